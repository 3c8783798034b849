#pragma once

#include <memory>
#include <optional>

#include "capi/include/honeycomb.h"
#include "python/pybind.h"

namespace honeycomb::Python {

/// What Python's Tables holds: shared with its evaluators.
class Tables {
 public:
  explicit Tables(hc_tables* made) : tables_(made, hc_tables_destroy) {}

  const hc_tables* get() const { return tables_.get(); }
  hc_tables_info info() const;
  /// None: the last level.
  std::int32_t level(const std::optional<std::int32_t>& given) const { return given ? *given : info().level_count; }
  hc_level_counts counts(const std::optional<std::int32_t>& level) const;

 private:
  std::shared_ptr<hc_tables> tables_;
};

}  // namespace honeycomb::Python
