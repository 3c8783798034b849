#pragma once

#include "apps/viewer/bindings.h"

namespace honeycomb::Viewer {

/// What the commands of one picture refer to.
struct Shot {
  const Pipelines& pipelines;
  const Targets& targets;
  const Bindings& bindings;
  const CellMesh& mesh;
  PointPush push;
  VkExtent2D extent;
  std::uint32_t shadows = 0;    ///< lights that throw some
  std::uint32_t cageLines = 0;  ///< of bindings.lines
  PointPush cage{};
  float spikes = 0;  ///< length of the normals to show, world units; 0: none
};

/// Records a picture, from the barrier behind the evaluator's writes on; it ends up in targets.resolved, in
/// VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, visible to copies.
void recordPicture(const Gpu& gpu, VkCommandBuffer commands, const Shot& shot);
/// Records the copy of such an image into a buffer that the host reads, 4 bytes a pixel.
void recordReadback(const Gpu& gpu, VkCommandBuffer commands, VkImage image, VkBuffer pixels, VkExtent2D extent);

}  // namespace honeycomb::Viewer
