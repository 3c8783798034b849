#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "far/tables/level_rows.h"
#include "far/tables/limit_table.h"
#include "far/tables/stencil_rows.h"

namespace honeycomb::Far {

/// The tables between the control points and what a stencil table starts from, made short: all below the first are
/// composed into one, for the points alone that the outputs need. A face of more than kLargestFolded sides would make
/// that quadratic in its sides whatever is asked for; then the chain stays as it is. Which of the two it is depends on
/// the tables alone, so that a row is the same whatever others are asked for.
class StencilChain {
 public:
  static constexpr std::int32_t kLargestFolded = 256;

  /// `tables`: the last first. They and `frames` must outlive the chain.
  StencilChain(std::span<const LevelTable* const> tables, std::span<const FrameIndex> frames);
  StencilChain(const StencilChain&) = delete;
  StencilChain& operator=(const StencilChain&) = delete;

  /// Composes what is below the first table for these outputs; false when that passes `most` entries.
  bool fold(std::span<const std::int32_t> outputs, std::int64_t most);

  /// To be used while the chain lives.
  StencilStart start() const { return {chain_, frames_}; }

 private:
  bool foldable() const;
  std::vector<std::int32_t> needed(std::span<const std::int32_t> outputs) const;

  std::vector<LevelRows> rows_;
  std::span<const FrameIndex> frames_;
  std::vector<const LevelRows*> chain_;
  LevelTable folded_;
  std::unique_ptr<LevelRows> foldedRows_;
};

}  // namespace honeycomb::Far
