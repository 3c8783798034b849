#pragma once

#include "apps/viewer/cell_mesh.h"
#include "apps/viewer/line_mesh.h"
#include "apps/viewer/pipelines.h"
#include "apps/viewer/targets.h"

namespace honeycomb::Viewer {

/// Three floats a point in a buffer made with VK_BUFFER_USAGE_STORAGE_BUFFER_BIT; offset and stride in floats, as in
/// Osd::BufferDescriptor.
struct PointSource {
  VkBuffer buffer = VK_NULL_HANDLE;
  std::int64_t offset = 0;
  std::int32_t stride = 3;

  /// Bytes from the buffer's start to the end of point `count` - 1.
  std::int64_t byteExtent(std::int32_t count) const {
    return 4 * (offset + (static_cast<std::int64_t>(count) - 1) * stride + 3);
  }
};

/// The descriptor sets of Pipelines, bound to a renderer's buffers.
struct Bindings {
  Owned<VkDescriptorPool> pool;
  VkDescriptorSet scene = VK_NULL_HANDLE;
  VkDescriptorSet points = VK_NULL_HANDLE;  ///< of the cells
  VkDescriptorSet lines = VK_NULL_HANDLE;   ///< of lines between points of their own
};

Bindings makeBindings(Maker& make, const Gpu& gpu, const Pipelines& pipelines);
/// Binds the scene block and the shadow maps, once.
void bindScene(const Gpu& gpu, const Bindings& bindings, const Buffer& scene, const Targets& targets);
/// Bind a mesh and its points, lines and theirs; nothing that uses the set may be running.
void bindPoints(const Gpu& gpu, const Bindings& bindings, const CellMesh& mesh, const PointSource& positions,
                const PointSource& normals);
void bindLines(const Gpu& gpu, const Bindings& bindings, const LineMesh& lines, const PointSource& positions);

}  // namespace honeycomb::Viewer
