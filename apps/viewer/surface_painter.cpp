#include "apps/viewer/surface_painter.h"

#include <utility>

#include "apps/viewer/cell_colours.h"

namespace honeycomb::Viewer {
namespace {

Result<CellMesh> uploadLevel(const Renderer& renderer, const Far::Refinement& refinement, std::int32_t level) {
  const Far::Topology& topology = refinement.level(level).topology;
  const std::vector<std::uint32_t> colours = cellColours(refinement, level);
  return renderer.upload({topology.vertexCount(), topology.faceOffsets(), topology.vert(), colours});
}

}  // namespace

SurfacePainter::SurfacePainter(DevicePoses poses, Renderer renderer, CellMesh cells, CellMesh cage)
    : poses_(std::move(poses)), renderer_(std::move(renderer)), cells_(std::move(cells)), cage_(std::move(cage)) {}

Result<SurfacePainter> SurfacePainter::create(const Osd::VulkanDevice& device, const Far::Refinement& refinement,
                                              const RendererOptions& options,
                                              const Osd::VulkanEvaluatorOptions& evaluation) {
  const auto evaluator = Osd::VulkanEvaluator::create(device, evaluation);
  if (!evaluator) return tl::unexpected(evaluator.error());
  auto poses = DevicePoses::create(*evaluator, refinement);
  if (!poses) return tl::unexpected(poses.error());
  auto renderer = Renderer::create(device, options);
  if (!renderer) return tl::unexpected(renderer.error());
  auto cells = uploadLevel(*renderer, refinement, refinement.levelCount());
  if (!cells) return tl::unexpected(cells.error());
  auto cage = uploadLevel(*renderer, refinement, 0);
  if (!cage) return tl::unexpected(cage.error());
  return SurfacePainter(std::move(*poses), std::move(*renderer), std::move(*cells), std::move(*cage));
}

Result<Picture> SurfacePainter::surface(const View& view) {
  const auto points = poses_.points();
  if (!points) return tl::unexpected(points.error());
  return renderer_.draw(cells_, points->refined, points->normals, view);
}

Result<Picture> SurfacePainter::cage(const View& view) {
  View faceted = view;
  faceted.style.faceted = true;
  const auto points = poses_.points();
  if (!points) return tl::unexpected(points.error());
  // Faces shaded by their own normals make no use of the points' normals: any numbers will do.
  return renderer_.draw(cage_, points->control, points->control, faceted);
}

}  // namespace honeycomb::Viewer
