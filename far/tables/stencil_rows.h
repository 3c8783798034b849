#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "far/tables/limit_table.h"
#include "far/tables/stencil_composer.h"

namespace honeycomb::Far {

/// Where the frame of each element stands in limit rows.
class FrameIndex {
 public:
  explicit FrameIndex(const LimitRows& rows);

  bool has(std::int32_t element) const { return place_[at(element)] >= 0; }
  /// The points that the element reads.
  std::span<const std::int32_t> points(std::int32_t element) const;

  /// Adds the position and tangents of an element to what the composer carries from `step` of its chain.
  template <std::size_t Lanes>
  void start(Composer<Lanes>& composer, std::size_t step, std::int32_t element) const {
    const FrameBatch& batch = batchOf(element);
    const std::span<const std::int32_t> index = points(element);
    const double* w = rows_.weights.data() + batch.firstWeight;
    // Whose A and B aren't T1 and T2.
    const bool hexagon = batch.sides == 6 && std::equal(kHexagonSpan.begin(), kHexagonSpan.end(), w + batch.sides);
    for (std::int32_t j = 0; j < batch.sides; ++j) {
      typename Composer<Lanes>::Weights weights{};
      for (std::size_t lane = 0; lane < Lanes; ++lane) weights[lane] = w[at(batch.sides) * lane + at(j)];
      if constexpr (Lanes == 3) {
        if (hexagon) {
          weights[1] -= weights[2] / 2;
          weights[2] *= std::numbers::sqrt3 / 2;
        }
      }
      composer.add(step, index[at(j)], weights);
    }
  }

 private:
  const FrameBatch& batchOf(std::int32_t element) const;

  const LimitRows& rows_;
  std::vector<std::int32_t> place_;
};

/// A chain of tables, the last first, and what the rows of a stencil table start from at its top: the points of the
/// first table themselves, or the frames of elements.
class StencilStart {
 public:
  using Chain = std::span<const LevelRows* const>;

  explicit StencilStart(Chain chain) : chain_(chain) {}
  /// `frames[i]` reads the targets of table i of the chain.
  StencilStart(Chain chain, std::span<const FrameIndex> frames) : chain_(chain), frames_(frames) {}

  Chain chain() const { return chain_; }
  bool ofLimits() const { return !frames_.empty(); }

  template <std::size_t Lanes>
  void start(Composer<Lanes>& composer, std::int32_t output) const {
    if (frames_.empty()) {
      typename Composer<Lanes>::Weights one{};
      one.fill(1);
      return composer.add(0, output, one);
    }
    const std::size_t step = frames_.front().has(output) ? 0 : 1;
    frames_[step].start(composer, step, output);
  }

  /// Do two outputs surely have entries for the same control points?
  bool sameSupport(std::int32_t a, std::int32_t b) const {
    return frames_.empty() && chain_.front()->place(a).sameFace(chain_.front()->place(b));
  }

 private:
  Chain chain_;
  std::span<const FrameIndex> frames_;
};

/// Where the entries of the rows go: for each row the next of `offsets`, entries sorted by control point.
struct StencilEntries {
  std::vector<std::int32_t> offsets;
  Array<std::int32_t> indices;
};

/// Counts the entries of the rows and sets the offsets. False, early and without them, when there are more than `most`.
bool countEntries(const StencilStart& start, std::span<const std::int32_t> outputs, std::int64_t most,
                  StencilEntries& entries);

/// Indices and weights of entries that have been counted; one array of weights a lane.
template <std::size_t Lanes>
void fillEntries(const StencilStart& start, std::span<const std::int32_t> outputs, StencilEntries& entries,
                 const std::array<std::vector<double>*, Lanes>& lanes);

}  // namespace honeycomb::Far
