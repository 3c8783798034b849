#include "apps/gallery/model.h"

#include "apps/viewer/cell_colours.h"
#include "far/base/index.h"
#include "osd/cpu_evaluator.h"

namespace honeycomb::Gallery {
namespace {

std::uint32_t packed(Viewer::Rgb colour) {
  return 0xff000000U | ((colour.value & 255U) << 16) | (colour.value & 0xff00U) | (colour.value >> 16);
}

Result<std::vector<float>> vertexNormals(const Surface& surface, std::int32_t vertexCount) {
  std::vector<float> normals(3 * at(vertexCount));
  Osd::TbbEvaluator evaluator;
  const auto done = evaluator.vertexLimits<float>(surface.refinement.limits(), {surface.points, {}}, {}, {normals, {}});
  if (!done) return tl::unexpected(done.error());
  return normals;
}

}  // namespace

std::int32_t Model::addPoint(glm::vec3 point, glm::vec3 normal) {
  for (int axis = 0; axis < 3; ++axis) {
    points.push_back(point[axis]);
    normals.push_back(normal[axis]);
  }
  return pointCount() - 1;
}

void Model::addFace(std::span<const std::int32_t> loop, Viewer::Rgb colour) {
  corners.insert(corners.end(), loop.begin(), loop.end());
  faceOffsets.push_back(static_cast<std::int32_t>(corners.size()));
  colours.push_back(packed(colour));
}

void Model::setColour(std::int32_t face, Viewer::Rgb colour) {
  colours[at(face)] = packed(colour);
}

Result<Surface> refine(const Shape& shape, std::span<const Far::Scheme> chain, bool limits) {
  const auto topology = Far::Topology::create(shape.polygons);
  if (!topology) return tl::unexpected(topology.error());
  auto refinement = Far::refine(*topology, chain, {.centralPoints = false, .limits = limits, .memoryLimit = 0});
  if (!refinement) return tl::unexpected(refinement.error());
  Surface surface{std::move(*refinement), shape.points};
  if (chain.empty()) return surface;
  surface.points.assign(3 * at(surface.refinement.last().pointCount()), 0);
  Osd::TbbEvaluator evaluator;
  const auto done = evaluator.evaluate<float>(surface.refinement, surface.refinement.levelCount(), {shape.points, {}},
                                              {surface.points, {}});
  if (!done) return tl::unexpected(done.error());
  return surface;
}

Result<Model> modelOf(const Surface& surface, Shading shading) {
  const Far::Topology& topology = surface.refinement.last().topology;
  Model model;
  model.faceOffsets.assign(topology.faceOffsets().begin(), topology.faceOffsets().end());
  model.corners.assign(topology.vert().begin(), topology.vert().end());
  model.colours = Viewer::cellColours(surface.refinement, surface.refinement.levelCount());
  const auto end = surface.points.begin() + 3 * static_cast<std::ptrdiff_t>(topology.vertexCount());
  model.points.assign(surface.points.begin(), end);
  model.normals = model.points;  // faces shaded by their own normals make no use of these
  model.faceted = shading == Shading::faceted;
  if (model.faceted) return model;
  auto normals = vertexNormals(surface, topology.vertexCount());
  if (!normals) return tl::unexpected(normals.error());
  model.normals = std::move(*normals);
  return model;
}

Result<Model> refined(const Shape& shape, const Result<std::vector<Far::Scheme>>& chain, Shading shading) {
  if (!chain) return tl::unexpected(chain.error());
  const Shading possible = chain->empty() ? Shading::faceted : shading;
  const auto surface = refine(shape, *chain, possible == Shading::smooth);
  return surface ? modelOf(*surface, possible) : tl::unexpected(surface.error());
}

Result<std::vector<Far::Scheme>> steps(const Result<Far::Scheme>& scheme, std::int32_t levels) {
  if (!scheme) return tl::unexpected(scheme.error());
  return std::vector<Far::Scheme>(at(levels), *scheme);
}

}  // namespace honeycomb::Gallery
