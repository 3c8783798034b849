#include "apps/viewer/surface_painter.h"

#include <fmt/format.h>

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

}  // namespace

SurfacePainter::SurfacePainter(Osd::VulkanFrames frames, Renderer renderer, CellMesh cells, CellMesh cage)
    : frames_(std::move(frames)), renderer_(std::move(renderer)), cells_(std::move(cells)), cage_(std::move(cage)) {}

Result<SurfacePainter> SurfacePainter::create(const Osd::VulkanDevice& device, const Far::Refinement& refinement,
                                              const RendererOptions& options,
                                              const Osd::VulkanEvaluatorOptions& evaluation) {
  auto evaluator = Osd::VulkanEvaluator::create(device, evaluation);
  if (!evaluator) return tl::unexpected(evaluator.error());
  Osd::VulkanTableOptions wanted;
  wanted.vertexLimits.normals = Osd::BufferDescriptor{};
  const auto table = evaluator->upload(refinement, wanted);
  if (!table) return tl::unexpected(table.error());
  // One is drawn while the next is refined.
  auto frames = Osd::VulkanFrames::create(
      *evaluator, *table, {.framesInFlight = 2, .frame = {.readers = VK_PIPELINE_STAGE_VERTEX_SHADER_BIT}});
  if (!frames) return tl::unexpected(frames.error());
  auto renderer = Renderer::create(device, options);
  if (!renderer) return tl::unexpected(renderer.error());
  auto cells = uploadLevel(*renderer, refinement, refinement.levelCount());
  if (!cells) return tl::unexpected(cells.error());
  auto cage = uploadLevel(*renderer, refinement, 0);
  if (!cage) return tl::unexpected(cage.error());
  return SurfacePainter(std::move(*frames), std::move(*renderer), std::move(*cells), std::move(*cage));
}

Result<void> SurfacePainter::pose(std::span<const float> control) {
  if (control.size() != 3 * static_cast<std::size_t>(cage_.vertexCount)) {
    return fail(ErrorCode::invalidOption, fmt::format("a frame of {} numbers was given to a mesh of {} control points",
                                                      control.size(), cage_.vertexCount));
  }
  const auto ticket = frames_.submit(control);
  if (!ticket) return tl::unexpected(ticket.error());
  posed_ = *ticket;
  return {};
}

std::span<const float> SurfacePainter::points() const {
  const auto slot = frames_.results(posed_);
  if (!slot || !frames_.wait(posed_)) return {};
  return (*slot)->numbers(Osd::PointBuffer::refined);
}

Result<PointSource> SurfacePainter::pointsOf(Osd::PointBuffer points) const {
  const auto slot = frames_.results(posed_);
  if (!slot) return tl::unexpected(slot.error());
  const Osd::VulkanRange range = (*slot)->range(points);
  return PointSource{range.buffer, static_cast<std::int64_t>(range.offset / sizeof(float)), 3};
}

Result<Picture> SurfacePainter::surface(const View& view) {
  const auto points = pointsOf(Osd::PointBuffer::refined);
  const auto normals = pointsOf(Osd::PointBuffer::vertexNormals);
  if (!points || !normals) return tl::unexpected(points ? normals.error() : points.error());
  return renderer_.draw(cells_, *points, *normals, view);
}

Result<Picture> SurfacePainter::cage(const View& view) {
  View faceted = view;
  faceted.style.faceted = true;
  const auto points = pointsOf(Osd::PointBuffer::control);
  if (!points) return tl::unexpected(points.error());
  // Faces shaded by their own normals make no use of the points' normals: any numbers will do.
  return renderer_.draw(cage_, *points, *points, faceted);
}

}  // namespace honeycomb::Viewer
