#include "apps/cli/frame_control.h"

namespace honeycomb::Cli {
namespace {

Result<std::span<const float>> vertexPoints(const MeshInput& input, const Animation* animation, std::int32_t f,
                                            FrameStorage& storage) {
  if (!animation) {
    storage.control.assign(input.mesh.positions.begin(), input.mesh.positions.end());
    return storage.control;
  }
  const Result<std::span<const float>> points = animation->frames->frame(f, storage.frame);
  if (!points) return tl::unexpected(inFile(animation->file, points.error()));
  return takeVertices(input, *points, storage.control);
}

}  // namespace

Result<std::span<const float>> controlPoints(const MeshInput& input, const Animation* animation,
                                             const CentralPoints& central, std::int32_t f, FrameStorage& storage) {
  Result<std::span<const float>> vertices = vertexPoints(input, animation, f, storage);
  if (!vertices || !central.given) return vertices;
  std::vector<float>& control = storage.control;
  if (vertices->data() != control.data()) control.assign(vertices->begin(), vertices->end());
  if (central.cache) {
    const Result<std::span<const float>> points = central.cache->frame(f);
    if (!points) return tl::unexpected(inFile(central.file, points.error()));
    control.insert(control.end(), points->begin(), points->end());
  } else if (!central.positions.empty()) {
    for (const double number : central.positions) control.push_back(static_cast<float>(number));
  } else {
    appendOffsetPoints<float>(input.mesh.polygons, central.offsets, control);
  }
  return control;
}

}  // namespace honeycomb::Cli
