#include "apps/viewer/surface_painter.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "apps/viewer/cell_colours.h"
#include "osd/vulkan/evaluator.h"

namespace honeycomb::Viewer {
namespace {

Result<CellMesh> uploadLevel(const Renderer& renderer, const Far::Refinement& refinement, std::int32_t level) {
  const Far::Topology& topology = refinement.level(level).topology;
  const std::vector<std::uint32_t> colours = cellColours(refinement, level);
  return renderer.upload({topology.vertexCount(), topology.faceOffsets(), topology.vert(), colours});
}

PointSource pointsIn(const Osd::VulkanRange& range) {
  return {range.buffer, static_cast<std::int64_t>(range.offset / sizeof(float)), 3};
}

}  // namespace

SurfacePainter::SurfacePainter(Osd::VulkanSession session, Renderer renderer, CellMesh cells, CellMesh cage)
    : session_(std::move(session)), renderer_(std::move(renderer)), cells_(std::move(cells)), cage_(std::move(cage)) {}

Result<SurfacePainter> SurfacePainter::create(const Osd::VulkanDevice& device, const Far::Refinement& refinement,
                                              const RendererOptions& options) {
  auto evaluator = Osd::VulkanEvaluator::create(device);
  if (!evaluator) return tl::unexpected(evaluator.error());
  Osd::VulkanTableOptions wanted;
  wanted.vertexLimits.normals = Osd::BufferDescriptor{};
  auto session = Osd::VulkanSession::create(*evaluator, refinement, wanted);
  if (!session) return tl::unexpected(session.error());
  auto renderer = Renderer::create(device, options);
  if (!renderer) return tl::unexpected(renderer.error());
  auto cells = uploadLevel(*renderer, refinement, refinement.levelCount());
  if (!cells) return tl::unexpected(cells.error());
  auto cage = uploadLevel(*renderer, refinement, 0);
  if (!cage) return tl::unexpected(cage.error());
  return SurfacePainter(std::move(*session), std::move(*renderer), std::move(*cells), std::move(*cage));
}

Result<void> SurfacePainter::pose(std::span<const float> control) {
  if (control.size() != session_.control().size()) {
    return fail(ErrorCode::invalidOption, fmt::format("a frame of {} numbers was given to a mesh of {} control points",
                                                      control.size(), cage_.vertexCount));
  }
  std::ranges::copy(control, session_.control().begin());
  return session_.run();
}

Result<Picture> SurfacePainter::surface(const View& view) {
  return renderer_.draw(cells_, pointsIn(session_.range(Osd::PointBuffer::refined)),
                        pointsIn(session_.range(Osd::PointBuffer::vertexNormals)), view);
}

Result<Picture> SurfacePainter::cage(const View& view) {
  View faceted = view;
  faceted.style.faceted = true;
  const PointSource points = pointsIn(session_.range(Osd::PointBuffer::control));
  // Faces shaded by their own normals make no use of the points' normals: any numbers will do.
  return renderer_.draw(cage_, points, points, faceted);
}

}  // namespace honeycomb::Viewer
