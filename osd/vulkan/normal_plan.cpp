#include <algorithm>

#include "far/base/index.h"
#include "osd/vulkan/plan.h"

namespace honeycomb::Osd {

namespace {

/// Cuts the sums of a table's points into dispatches: as many points as slices hold, of one window of the target.
class NormalPlanner {
 public:
  NormalPlanner(const StagePlanner& stage, const Far::NormalTable& table, const Section& offsets, const Section& faces)
      : stage_(stage), table_(table), offsets_(offsets), faces_(faces) {}

  Result<std::vector<Dispatch>> plan();

 private:
  Result<void> planPoints(ItemRange points);

  const StagePlanner& stage_;
  const Far::NormalTable& table_;
  Section offsets_, faces_;
  std::vector<Dispatch> dispatches_;
};

Result<std::vector<Dispatch>> NormalPlanner::plan() {
  const RowCapacity capacity{stage_.sliceCapacity(offsets_) - 1, stage_.sliceCapacity(faces_)};
  for (std::int64_t begin = 0; begin < std::ssize(table_.offsets) - 1;) {
    const ItemRange points{begin, endOfRows(table_.offsets, begin, capacity)};
    if (const auto planned = planPoints(points); !planned) return tl::unexpected(planned.error());
    begin = points.end;
  }
  return std::move(dispatches_);
}

Result<void> NormalPlanner::planPoints(ItemRange points) {
  const std::int64_t first = table_.offsets[at(points.begin)];
  const auto offsets = stage_.slice(offsets_, points.begin, points.end - points.begin + 1);
  if (!offsets) return tl::unexpected(offsets.error());
  const auto faces = stage_.slice(faces_, first, table_.offsets[at(points.end)] - first);
  if (!faces) return tl::unexpected(faces.error());
  for (const Window& window : stage_.windows(stage_.target(), points.begin, points.end - 1)) {
    const ItemRange some = stage_.itemsIn(window, {0, 1}, points);
    if (some.begin >= some.end) continue;
    Dispatch dispatch = stage_.dispatch(Kernel::normals);
    dispatch.push.count = static_cast<std::uint32_t>(some.end - some.begin);
    dispatch.push.firstOutput = static_cast<std::uint32_t>(some.begin);
    dispatch.push.firstTask = offsets->first + static_cast<std::uint32_t>(some.begin - points.begin);
    // The kernel adds a point's offset, which counts from the first of all: wraps round, as in the kernel.
    dispatch.push.firstIndex = faces->first - static_cast<std::uint32_t>(first);
    rangeOf(dispatch, Slot::indices) = faces->range;
    rangeOf(dispatch, Slot::tasks) = offsets->range;
    stage_.bindTarget(dispatch, window);
    if (auto shaped = stage_.shape(dispatch, dispatch.push.count); !shaped) return shaped;
    dispatches_.push_back(dispatch);
  }
  return {};
}

}  // namespace

Result<StagePlan> planNormals(const VulkanLimits& limits, const Far::NormalTable& table,
                              const BufferDescriptor& normals, TableImage& image) {
  const StagePlanner stage(limits, {BufferDescriptor{}, table.faceNormals}, {normals, std::ssize(table.offsets) - 1});
  if (const auto sound = stage.check(); !sound) return tl::unexpected(sound.error());
  const Section offsets = image.add(table.offsets), faces = image.add(table.faces);
  auto dispatches = NormalPlanner(stage, table, offsets, faces).plan();
  if (!dispatches) return tl::unexpected(dispatches.error());
  StagePlan plan;
  plan.sourceBytes = stage.sourceBytes();
  plan.targetBytes = stage.targetBytes();
  plan.steps.push_back(std::move(*dispatches));
  return plan;
}

}  // namespace honeycomb::Osd
