#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "far/base/result.h"
#include "far/tables/half_box_patch.h"
#include "far/tables/level_table.h"
#include "far/tables/patch_table.h"

namespace honeycomb::Far {

/// The weights other than zero of a row over what a patch reads. A face of more than kLargestCirculant sides counts as
/// a hexagon there, whose corners are its six slots; what else is read of it are its three sums.
struct PatchWeights {
  std::vector<std::int32_t> points;  ///< places as in VertexPatch::point
  std::vector<double> weights;       ///< one a point
  /// What is read of the sums of a large face, the patch's corners counted from the patch's vertex.
  struct Share {
    std::size_t face = 0;  ///< 0 .. 2
    double mean = 0, cosine = 0, sine = 0;
  };
  std::vector<Share> shares;
};

/// `sides`: of the patch's faces. Linear in those that aren't large.
PatchWeights patchWeights(const std::array<std::int32_t, 3>& sides, const PatchRow& row);

/// A row and the patch whose points it reads.
struct PlacedPatchRow {
  std::int32_t patch = 0;
  const PatchWeights* row = nullptr;
};

/// Row i writes point i: loose rows, and summed ones where they read large faces, whose sums are made once. Linear in
/// the rows' entries and the sides of these faces. Errors: tooLarge past 2^31 - 1 weights.
Result<LevelTable> patchRowTable(const PatchTable& patches, std::span<const PlacedPatchRow> rows);

}  // namespace honeycomb::Far
