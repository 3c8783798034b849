#include "far/tables/crease_ends.h"

#include <algorithm>
#include <utility>

#include "far/base/index.h"
#include "far/tables/face_sums.h"
#include "far/tables/level_rows.h"

namespace honeycomb::Far {

namespace {

/// The mean of the rows of a corner face's points behind the corner and its two neighbours, which come first.
Row barycentreRow(const Topology& child, std::int32_t f, const LevelRows& rows, FaceSums& sums) {
  constexpr std::int32_t kCut = 3;
  Row row;
  const double share = 1.0 / (child.sides(f) - kCut);
  for (std::int32_t h = child.faceOffsets()[at(f)] + kCut; h < child.faceOffsets()[at(f) + 1]; ++h) {
    sums.append(rows, child.vert(h), share, row);
  }
  mergeEntries(row);
  return row;
}

}  // namespace

RowChanges creaseEndRows(const Topology& child, const CreaseChildren& creases, const LevelTable& table,
                         bool centralPoints) {
  std::vector<ReplacedRow> ends;
  const LevelRows rows(table);
  FaceSums sums(table);
  for (const CreaseEdge& crease : creases.creases) {
    // At an end the two sides of the crease follow each other round the same corner.
    const std::int32_t into = child.next(crease.halfEdge) == crease.mate ? crease.halfEdge : crease.mate;
    if (child.next(into) != (into == crease.halfEdge ? crease.mate : crease.halfEdge)) continue;
    const std::int32_t corner = child.dest(into);
    if (std::binary_search(creases.heldCorners.begin(), creases.heldCorners.end(), corner)) continue;
    const std::int32_t f = child.face(into);
    ends.push_back({corner, barycentreRow(child, f, rows, sums)});
    if (centralPoints) ends.push_back({child.vertexCount() + f, ends.back().row});
  }
  std::sort(ends.begin(), ends.end(), [](const ReplacedRow& a, const ReplacedRow& b) { return a.output < b.output; });
  return {std::move(ends), std::move(sums).added()};
}

}  // namespace honeycomb::Far
