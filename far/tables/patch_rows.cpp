#include "far/tables/patch_rows.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/tables/summed_row_writer.h"

namespace honeycomb::Far {
namespace {

using PatchSides = std::array<std::int32_t, 3>;

/// Of a large face: mean, cosine and sine, counted from its first half-edge.
constexpr std::int32_t kPatchFaceSums = 3;

/// What comes before the weights of a sum: two that only faces with outputs read.
constexpr std::int32_t kUnread = 2;

bool isLarge(std::int32_t sides) {
  return sides > kLargestCirculant;
}

/// Large faces as hexagons.
PatchSides withSlots(PatchSides sides) {
  for (std::int32_t& n : sides) n = isLarge(n) ? 6 : n;
  return sides;
}

class PatchRowTable {
 public:
  PatchRowTable(const PatchTable& patches, std::span<const PlacedPatchRow> rows)
      : patches_(patches), topology_(patches.topology()), rows_(rows) {}

  Result<LevelTable> build() {
    findLargeFaces();
    if (Result<void> fits = checkSize(); !fits) return tl::unexpected(fits.error());
    table_.sourceCount = topology_.vertexCount();
    table_.targetCount = static_cast<std::int32_t>(rows_.size());
    for (const auto& [face, number] : firstSums_) addSums(face);
    addSummed();
    addLoose();
    table_.weightsSingle.assign(table_.weights.begin(), table_.weights.end());
    return std::move(table_);
  }

 private:
  const PatchWeights& row(std::int64_t i) const { return *rows_[at(i)].row; }
  bool isSummed(std::int64_t i) const { return !row(i).shares.empty(); }
  std::int64_t rowCount() const { return static_cast<std::int64_t>(rows_.size()); }

  void findLargeFaces() {
    for (std::int64_t i = 0; i < rowCount(); ++i) {
      if (!isSummed(i)) continue;
      const PatchSides faces = patches_.patch(rows_[at(i)].patch).faces();
      for (const PatchWeights::Share& share : row(i).shares) firstSums_.try_emplace(faces[share.face]);
    }
    std::int32_t number = 0;
    for (auto& entry : firstSums_) entry.second = kPatchFaceSums * number++;
  }

  Result<void> checkSize() const {
    constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();
    std::int64_t total = 0;
    for (const auto& [face, number] : firstSums_) {
      total += kPatchFaceSums * (std::int64_t{topology_.sides(face)} + kUnread);
    }
    for (const PlacedPatchRow& placed : rows_) {
      total += static_cast<std::int64_t>(placed.row->points.size() + kPatchFaceSums * placed.row->shares.size());
    }
    if (total <= kMost && rowCount() <= kMost) return {};
    return fail(ErrorCode::tooLarge,
                fmt::format("the stencils of {} points of the surface hold {} weights, more than 2^31 - 1; take fewer "
                            "points at a time",
                            rows_.size(), total));
  }

  void addSums(std::int32_t face) {
    const std::int32_t n = topology_.sides(face);
    const auto firstIndex = static_cast<std::int32_t>(table_.indices.size());
    const auto corners = topology_.vert().subspan(at(topology_.faceOffsets()[at(face)]), at(n));
    table_.indices.edit().append(corners.begin(), corners.end());
    const auto add = [&](const auto& weightOf) {
      table_.projected.push_back({n, 0, 0, firstIndex, 0, static_cast<std::int32_t>(table_.weights.size())});
      table_.weights.resize(table_.weights.size() + kUnread, 0.0);
      for (std::int32_t j = 0; j < n; ++j) table_.weights.push_back(weightOf(2 * std::numbers::pi * j / n));
    };
    add([n](double) { return 1.0 / n; });
    add([](double angle) { return std::cos(angle); });
    add([](double angle) { return std::sin(angle); });
  }

  /// The vertex in a place of a patch, large faces counted as hexagons.
  std::int32_t point(const VertexPatch& patch, std::int32_t place) const {
    const PatchSides sides = patch.sides();
    const PatchSides slots = withSlots(sides);
    if (place < 4 || sides == slots) return patch.point(place);
    std::int32_t corner = place - 4 + 2;
    std::size_t face = 0;
    for (; corner > slots[face] - 2; ++face) corner -= slots[face] - 3;
    return patch.corner(face, isLarge(sides[face]) ? slotCorner(corner, sides[face]) : corner);
  }

  Row rowOf(const PlacedPatchRow& placed) const {
    const VertexPatch patch = patches_.patch(placed.patch);
    Row row;
    for (std::size_t j = 0; j < placed.row->points.size(); ++j) {
      row.push_back({point(patch, placed.row->points[j]), placed.row->weights[j]});
    }
    for (const PatchWeights::Share& share : placed.row->shares) addShare(patch, share, row);
    return row;
  }

  /// With t the angle of the patch's vertex in the face, counted from the face's first half-edge, its own cosine sum is
  /// cos t C + sin t S and its sine sum cos t S - sin t C.
  void addShare(const VertexPatch& patch, const PatchWeights::Share& share, Row& row) const {
    const std::int32_t h = patch.halfEdges()[share.face];
    const std::int32_t face = topology_.face(h);
    const double t = 2 * std::numbers::pi * (h - topology_.faceOffsets()[at(face)]) / topology_.sides(face);
    const double cosine = share.cosine * std::cos(t) - share.sine * std::sin(t);
    const double sine = share.cosine * std::sin(t) + share.sine * std::cos(t);
    const std::int32_t first = table_.sourceCount + firstSums_.at(face);
    if (share.mean != 0) row.push_back({first, share.mean});
    if (cosine != 0) row.push_back({first + 1, cosine});
    if (sine != 0) row.push_back({first + 2, sine});
  }

  void addSummed() {
    SummedRowWriter writer(table_);
    for (std::int64_t first = 0; first < rowCount();) {
      std::int64_t end = first;
      while (end < rowCount() && isSummed(end)) ++end;
      const auto makeRow = [&](std::int64_t i, Row& row) { row = rowOf(rows_[at(first + i)]); };
      if (end > first) writer.add(static_cast<std::int32_t>(first), end - first, makeRow);
      first = end + 1;
    }
    writer.finish();
  }

  void addLoose() {
    LooseRows& loose = table_.loose;
    for (std::int64_t i = 0; i < rowCount(); ++i) {
      if (isSummed(i)) continue;
      loose.outputs.push_back(static_cast<std::int32_t>(i));
      loose.offsets.push_back(loose.offsets.back() + static_cast<std::int32_t>(row(i).points.size()));
    }
    loose.firstIndex = static_cast<std::int32_t>(table_.indices.size());
    loose.firstWeight = static_cast<std::int32_t>(table_.weights.size());
    Array<std::int32_t>& indices = table_.indices.edit();
    indices.resize(indices.size() + at(loose.offsets.back()));
    table_.weights.resize(table_.weights.size() + at(loose.offsets.back()));
    const auto write = [&](std::int64_t r) {
      const PlacedPatchRow& placed = rows_[at(loose.outputs[at(r)])];
      const VertexPatch patch = patches_.patch(placed.patch);
      const auto first = at(loose.offsets[at(r)]);
      for (std::size_t j = 0; j < placed.row->points.size(); ++j) {
        indices[at(loose.firstIndex) + first + j] = point(patch, placed.row->points[j]);
        table_.weights[at(loose.firstWeight) + first + j] = placed.row->weights[j];
      }
    };
    constexpr std::int64_t kRowGrain = 256;
    Parallel::forEach(0, loose.rowCount(), write, kRowGrain);
  }

  const PatchTable& patches_;
  const Topology& topology_;
  std::span<const PlacedPatchRow> rows_;
  std::map<std::int32_t, std::int32_t> firstSums_;  // by large face: the number of its first sum
  LevelTable table_;
};

}  // namespace

PatchWeights patchWeights(const std::array<std::int32_t, 3>& sides, const PatchRow& row) {
  PatchWeights result;
  const std::vector<double> all = pointWeights(withSlots(sides), row);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i] == 0) continue;
    result.points.push_back(static_cast<std::int32_t>(i));
    result.weights.push_back(all[i]);
  }
  for (std::size_t face = 0; face < 3; ++face) {
    const PatchWeights::Share share{face, row[9 * face + 6], row[9 * face + 7], row[9 * face + 8]};
    const bool read = share.mean != 0 || share.cosine != 0 || share.sine != 0;
    if (isLarge(sides[face]) && read) result.shares.push_back(share);
  }
  return result;
}

Result<LevelTable> patchRowTable(const PatchTable& patches, std::span<const PlacedPatchRow> rows) {
  return PatchRowTable(patches, rows).build();
}

}  // namespace honeycomb::Far
