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
};

/// Records a whole picture, from the barrier behind the evaluator's writes to the copy into targets.pixels.
void recordPicture(const Gpu& gpu, VkCommandBuffer commands, const Shot& shot);

}  // namespace honeycomb::Viewer
