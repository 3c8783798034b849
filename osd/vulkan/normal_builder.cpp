#include "far/base/index.h"
#include "osd/vulkan/table_builder.h"

namespace honeycomb::Osd {

// The dispatches that find unit normals from points, which both lie where the places say.
Result<TableBuilder::Steps> TableBuilder::normalsOf(const Far::LimitRows& rows, const Place& points,
                                                    const Place& normals) {
  if (rows.batches.empty()) return Steps{};
  return frames(rows, {.normals = normals.layout.desc}, normals.layout.count, points, PointBuffer::vertexPositions,
                normals.points);
}

// The normals of faces born at level k are found from its points beside the next level, in the same phase.
Result<void> TableBuilder::joinFaceNormals(const Far::NormalTable& table, std::size_t k, const Place& points,
                                           Steps& next) {
  auto steps = normalsOf(table.frames[k], points, placeOf(PointBuffer::sharedNormals, table.faceNormals));
  if (!steps) return tl::unexpected(steps.error());
  for (const std::vector<TableDispatch>& step : *steps) {
    next.front().insert(next.front().end(), step.begin(), step.end());
  }
  return {};
}

// Those of the points, once all levels are there.
Result<void> TableBuilder::addNormalSums(const Far::NormalTable& table) {
  TableImage image(core_->limits.alignment);
  const auto plan = planNormals(core_->limits, table, *normals(), image);
  if (!plan) return tl::unexpected(plan.error());
  need(PointBuffer::vertexNormals, plan->targetBytes);
  TableStage stage;
  stage.source = PointBuffer::sharedNormals;
  stage.target = PointBuffer::vertexNormals;
  auto steps = addStage(*plan, image, std::move(stage));
  if (!steps) return tl::unexpected(steps.error());
  append(*steps);
  return {};
}

}  // namespace honeycomb::Osd
