#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "far/tables/level_table.h"
#include "far/tables/limit_table.h"
#include "far/tables/refinement.h"

namespace honeycomb::Far {

/// The level tables of a refinement and its limits, which is all that evaluators read of one: a view of tables that
/// stand in a Refinement or come from a TableFile, and outlive it. As cheap to copy as a span.
class LevelTables {
 public:
  /// Those of a refinement.
  LevelTables(const Refinement& refinement)
      : first_(reinterpret_cast<const std::byte*>(&refinement.level(0).table)),
        step_(sizeof(Level)),
        count_(refinement.levelCount()),
        limits_(&refinement.limits()) {}
  /// `tables[k]` leads to level k, from level k - 1; tables[0] is empty. At least one.
  LevelTables(std::span<const LevelTable> tables, const LimitTable& limits)
      : first_(reinterpret_cast<const std::byte*>(tables.data())),
        step_(sizeof(LevelTable)),
        count_(static_cast<std::int32_t>(tables.size()) - 1),
        limits_(&limits) {}

  /// The last level L.
  std::int32_t levelCount() const { return count_; }
  /// From level k - 1 to level k, 1 <= k <= levelCount().
  const LevelTable& table(std::int32_t k) const {
    return *reinterpret_cast<const LevelTable*>(first_ + static_cast<std::size_t>(k) * step_);
  }
  /// Points of level k, 0 <= k <= levelCount(); none where there is no table.
  std::int32_t pointCount(std::int32_t k) const {
    if (count_ == 0) return 0;
    return k == 0 ? table(1).sourceCount : table(k).targetCount;
  }
  /// Of the last level; empty where there are none.
  const LimitTable& limits() const { return *limits_; }

 private:
  const std::byte* first_;
  std::size_t step_;  // bytes from one table to the next
  std::int32_t count_;
  const LimitTable* limits_;
};

}  // namespace honeycomb::Far
