#include "bench/kit/workbench.h"

#include "far/base/index.h"

namespace honeycomb::Bench {

namespace {

std::size_t sizeOf(const Task& task, std::int64_t points) {
  return at(task.layout.desc.extent(points));
}

std::size_t controlSize(const Task& task) {
  return sizeOf(task, task.refinement.level(1).table.sourceCount);
}
std::size_t refinedSize(const Task& task) {
  return sizeOf(task, task.refinement.last().table.targetCount);
}
std::size_t normalsSize(const Task& task) {
  return task.normals == Normals::none ? 0 : 3 * at(task.refinement.last().pointCount());
}

/// The points in single precision, in the task's layout.
void fillControl(const Task& task, std::span<float> control) {
  const Osd::BufferDescriptor& desc = task.layout.desc;
  for (std::size_t v = 0; 3 * v < task.points.size(); ++v) {
    float* point = &control[v * at(desc.stride)];
    for (std::size_t c = 0; c < 3; ++c) point[c] = static_cast<float>(task.points[3 * v + c]);
    if (desc.length == 4) point[3] = 1;
  }
}

}  // namespace

Workbench::Workbench(const Task& task)
    : control_(controlSize(task)),
      refined_(refinedSize(task)),
      normals_(normalsSize(task)),
      flat_(task.refinement, task.memory),
      problem_{task.refinement,
               task.layout,
               task.normals,
               control_.first(controlSize(task)),
               refined_.first(refinedSize(task)),
               normals_.first(normalsSize(task)),
               task.tablesMs,
               flat_} {
  fillControl(task, control_.all());
}

}  // namespace honeycomb::Bench
