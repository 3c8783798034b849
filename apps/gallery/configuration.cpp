#include "apps/gallery/configuration.h"

#include "far/base/index.h"
#include "far/schemes/half_box.h"
#include "far/tables/natural_configuration.h"

namespace honeycomb::Gallery {
namespace {

/// The polygons of a level, faces in the level's order.
Far::Polygons polygonsOf(const Far::Topology& topology) {
  Far::Polygons polygons;
  polygons.vertexCount = topology.vertexCount();
  polygons.faceOffsets.assign(topology.faceOffsets().begin(), topology.faceOffsets().end());
  polygons.indices.assign(topology.vert().begin(), topology.vert().end());
  return polygons;
}

/// The face of the topology that is the caller's face 0.
std::int32_t firstInputFace(const Far::Topology& topology) {
  std::int32_t f = 0;
  while (topology.inputFace(f) != 0) ++f;
  return f;
}

std::int32_t childOf(const Far::Topology& refined, std::int32_t face) {
  std::int32_t f = 0;
  while (refined.parentKind(f) != Far::FaceParent::face || refined.parents()[at(f)] != face) ++f;
  return f;
}

}  // namespace

Result<Configuration> configuration(std::int32_t sides, double tunedWeight) {
  const auto natural = Far::naturalConfiguration(sides, tunedWeight);
  if (!natural) return tl::unexpected(natural.error());
  Shape mesh{natural->polygons, {}};
  for (std::size_t i = 0; i < natural->points.size(); i += 3) {
    const double ground[] = {natural->points[i], 0, -natural->points[i + 1]};
    for (const double number : ground) mesh.points.push_back(static_cast<float>(number));
  }
  Far::HalfBoxOptions options;
  options.tunedWeights = {{sides, tunedWeight}};
  const auto chain = steps(Far::halfBoxStep(options, true), 1);
  if (!chain) return tl::unexpected(chain.error());
  auto surface = refine(mesh, *chain);
  if (!surface) return tl::unexpected(surface.error());
  const Far::Topology& control = surface->refinement.level(0).topology;
  const Far::Topology& refined = surface->refinement.level(1).topology;
  auto table = Far::PatchTable::build(control);
  if (!table) return tl::unexpected(table.error());
  auto finerTable = Far::PatchTable::build(refined);
  if (!finerTable) return tl::unexpected(finerTable.error());
  const std::int32_t middle = firstInputFace(control);
  Shape finer{polygonsOf(refined), surface->points};
  return Configuration{sides,  std::move(mesh),         std::move(*table), std::move(finer), std::move(*finerTable),
                       middle, childOf(refined, middle)};
}

Shape lifted(const Shape& mesh, const std::function<float(std::size_t vertex, float x, float z)>& height) {
  Shape shape = mesh;
  for (std::size_t v = 0; 3 * v < shape.points.size(); ++v) {
    shape.points[3 * v + 1] = height(v, shape.points[3 * v], shape.points[3 * v + 2]);
  }
  return shape;
}

}  // namespace honeycomb::Gallery
