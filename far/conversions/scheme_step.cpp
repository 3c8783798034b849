#include "far/conversions/scheme_step.h"

#include <fmt/format.h>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/conversions/conversion_parts.h"
#include "far/conversions/conversions.h"
#include "far/tables/level_rows.h"
#include "far/tables/refinement.h"

namespace honeycomb::Far {
namespace {

Result<void> setRows(const LevelRows& level, WeightedRows& rows) {
  std::vector<std::int32_t> lengths(at(level.rowCount()));
  Parallel::forEach(0, level.rowCount(),
                    [&](std::int64_t r) { lengths[at(r)] = level.entryCount(static_cast<std::int32_t>(r)); });
  std::int64_t entries = 0;
  for (const std::int32_t length : lengths) entries += length;
  if (entries > kMaxRowEntries)
    return fail(ErrorCode::tooLarge,
                fmt::format("the rows of the step would have {} entries, past {}, as faces of many sides give "
                            "N rows of N; refine the mesh one level instead, which needs no rows",
                            entries, kMaxRowEntries));
  layOutRows(rows, lengths);
  Parallel::forEach(0, level.rowCount(), [&](std::int64_t r) {
    std::size_t b = at(rows.offsets[at(r)]);
    level.visit(static_cast<std::int32_t>(r), [&](std::int32_t point, double weight) {
      rows.indices[b] = point;
      rows.weights[b++] = weight;
    });
  });
  return {};
}

void setPolygons(const Topology& control, const Topology& refined, Conversion& result) {
  result.polygons.vertexCount = refined.vertexCount();
  result.polygons.faceOffsets.assign(refined.faceOffsets().begin(), refined.faceOffsets().end());
  result.polygons.indices.assign(refined.vert().begin(), refined.vert().end());
  result.polygons.corners = taggedCorners(refined);
  result.faceSources.resize(at(refined.faceCount()));
  Parallel::forEach(0, refined.faceCount(), [&](std::int64_t i) {
    const auto f = static_cast<std::int32_t>(i);
    const std::int32_t parent = refined.parents()[at(f)];
    const FaceParent kind = refined.parentKind(f);
    result.faceSources[at(f)] = {kind, kind == FaceParent::face ? control.inputFace(parent) : parent};
  });
}

}  // namespace

Result<Conversion> schemeStep(const Topology& topology, const Scheme& scheme) {
  const Result<Refinement> refinement = refine(topology, scheme, 1);
  if (!refinement) return tl::unexpected(refinement.error());
  Conversion result;
  result.sourceCount = topology.vertexCount();
  if (const auto done = setRows(LevelRows(refinement->last().table), result.rows); !done)
    return tl::unexpected(done.error());
  setPolygons(topology, refinement->last().topology, result);
  result.step = scheme;
  return result;
}

}  // namespace honeycomb::Far
