#include "osd/vulkan/projected_plan.h"

#include <algorithm>
#include <utility>

namespace honeycomb::Osd {

namespace {

using Far::kProjectionBlock;
using Far::ProjectedFace;

// Entries of the tables in which a group of faces is described to the kernels.
constexpr std::int64_t kRecordEntries = 8;
constexpr std::int64_t kTaskEntries = 2;

struct Extent {
  std::int64_t begin = 0, end = 0;
  std::int64_t size() const { return end - begin; }
  Extent with(std::int64_t first, std::int64_t count) const {
    return size() == 0 ? Extent{first, first + count} : Extent{std::min(begin, first), std::max(end, first + count)};
  }
};

// Faces that one dispatch can take: all they need fits into slices of a page.
struct Group {
  Extent faces, indices, weights, outputs;
  std::int64_t blocks = 0, tasks = 0;
};

std::int64_t weightCount(const ProjectedFace& face) {
  if (face.outputs == 0) return 2 + std::int64_t{face.corners};
  return 2 + 3 * (std::int64_t{face.corners} + std::int64_t{face.outputs});
}
std::int64_t blockCount(const ProjectedFace& face) {
  return (face.corners + kProjectionBlock - 1) / kProjectionBlock;
}
std::int64_t taskCount(const ProjectedFace& face) {
  return (face.outputs + std::int64_t{kWorkgroupSize} - 1) / kWorkgroupSize;
}

class ProjectedPlanner {
 public:
  ProjectedPlanner(const StagePlanner& stage, std::span<const ProjectedFace> faces, const Section& indices,
                   const Section& weights, TableImage& image)
      : stage_(stage), faces_(faces), indices_(indices), weights_(weights), image_(image) {}

  Result<ProjectedPlan> plan();

 private:
  std::int64_t sumsPerFace() const { return 3 * std::int64_t{stage_.target().desc.length}; }
  Group with(Group group, std::int64_t f) const;
  bool fits(const Group& group) const;
  Result<void> planGroup(const Group& group, const BoundRange& sums);
  Result<Dispatch> bindFaces(const Group& group);
  Result<void> planOutputs(const Group& group, Dispatch dispatch, const BoundRange& sums);
  Result<Slice> wholeSlice(const Section& section) const { return stage_.slice(section, 0, section.count); }
  Section addRecords(const Group& group);
  Section addBlockTasks(const Group& group);
  Section addOutputTasks(const Group& group);
  BoundRange addPartials(std::int64_t numbers);
  BoundRange addSums(const Group& group);
  const ProjectedFace& face(std::int64_t f) const { return faces_[static_cast<std::size_t>(f)]; }

  const StagePlanner& stage_;
  std::span<const ProjectedFace> faces_;
  Section indices_, weights_;
  TableImage& image_;
  ProjectedPlan plan_;
};

Result<ProjectedPlan> ProjectedPlanner::plan() {
  const auto count = static_cast<std::int64_t>(faces_.size());
  std::vector<Group> groups;
  std::vector<BoundRange> sums;
  for (std::int64_t f = 0; f < count;) {
    Group group = with({}, f++);
    while (f < count && fits(with(group, f))) group = with(group, f++);
    groups.push_back(group);
    sums.push_back(addSums(group));
  }
  plan_.sumBytes = plan_.partialBytes;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (const auto planned = planGroup(groups[g], sums[g]); !planned) return tl::unexpected(planned.error());
  }
  return std::move(plan_);
}

Group ProjectedPlanner::with(Group group, std::int64_t f) const {
  const ProjectedFace& added = face(f);
  group.faces = group.faces.with(f, 1);
  group.indices = group.indices.with(added.firstIndex, added.corners);
  group.weights = group.weights.with(added.firstWeight, weightCount(added));
  if (added.outputs > 0) group.outputs = group.outputs.with(added.firstOutput, added.outputs);
  group.blocks += blockCount(added);
  group.tasks += taskCount(added);
  return group;
}

bool ProjectedPlanner::fits(const Group& group) const {
  const auto page = static_cast<std::int64_t>(stage_.limits().pageNumbers());
  const std::int64_t most =
      std::max({group.blocks * sumsPerFace(), group.faces.size() * std::max(sumsPerFace(), kRecordEntries),
                group.blocks * kTaskEntries, group.tasks * kTaskEntries});
  return most <= page && group.indices.size() <= stage_.sliceCapacity(indices_) &&
         group.weights.size() <= stage_.sliceCapacity(weights_);
}

Section ProjectedPlanner::addRecords(const Group& group) {
  std::vector<std::uint32_t> records;
  std::int64_t block = 0;
  for (std::int64_t f = group.faces.begin; f < group.faces.end; ++f) {
    const ProjectedFace& one = face(f);
    for (const std::int64_t entry :
         {std::int64_t{one.corners}, std::int64_t{one.outputs}, std::int64_t{one.firstCorner},
          one.firstIndex - group.indices.begin, std::int64_t{one.firstOutput}, one.firstWeight - group.weights.begin,
          block, blockCount(one)}) {
      records.push_back(static_cast<std::uint32_t>(entry));
    }
    block += blockCount(one);
  }
  return image_.add(std::move(records));
}

Section ProjectedPlanner::addBlockTasks(const Group& group) {
  std::vector<std::uint32_t> tasks;
  for (std::int64_t f = group.faces.begin; f < group.faces.end; ++f) {
    for (std::int64_t b = 0; b < blockCount(face(f)); ++b) {
      tasks.push_back(static_cast<std::uint32_t>(f - group.faces.begin));
      tasks.push_back(static_cast<std::uint32_t>(b * kProjectionBlock));
    }
  }
  return image_.add(std::move(tasks));
}

Section ProjectedPlanner::addOutputTasks(const Group& group) {
  std::vector<std::uint32_t> tasks;
  for (std::int64_t f = group.faces.begin; f < group.faces.end; ++f) {
    for (std::int64_t t = 0; t < taskCount(face(f)); ++t) {
      tasks.push_back(static_cast<std::uint32_t>(f - group.faces.begin));
      tasks.push_back(static_cast<std::uint32_t>(t * kWorkgroupSize));
    }
  }
  return image_.add(std::move(tasks));
}

BoundRange ProjectedPlanner::addPartials(std::int64_t numbers) {
  const std::uint64_t alignment = stage_.limits().alignment;
  const BoundRange range{Role::partials, plan_.partialBytes, static_cast<std::uint64_t>(numbers) * sizeof(float)};
  plan_.partialBytes += (range.size + alignment - 1) / alignment * alignment;
  return range;
}

BoundRange ProjectedPlanner::addSums(const Group& group) {
  const BoundRange sums = addPartials(group.faces.size() * sumsPerFace());
  for (std::int64_t f = 0; f < group.faces.size(); ++f) {
    const std::uint64_t number = sums.offset / sizeof(float) + static_cast<std::uint64_t>(f * sumsPerFace());
    plan_.sumNumbers.push_back(static_cast<std::uint32_t>(number));
  }
  return sums;
}

// What the three kernels have in common: the faces and where their indices and weights lie.
Result<Dispatch> ProjectedPlanner::bindFaces(const Group& group) {
  const auto indices = stage_.slice(indices_, group.indices.begin, group.indices.size());
  if (!indices) return tl::unexpected(indices.error());
  const auto weights = stage_.slice(weights_, group.weights.begin, group.weights.size());
  if (!weights) return tl::unexpected(weights.error());
  const auto records = wholeSlice(addRecords(group));
  if (!records) return tl::unexpected(records.error());
  Dispatch dispatch = stage_.dispatch(Kernel::projectedBlocks);
  dispatch.push.firstIndex = indices->first;
  dispatch.push.firstWeight = weights->first;
  rangeOf(dispatch, Slot::indices) = indices->range;
  rangeOf(dispatch, Slot::weights) = weights->range;
  rangeOf(dispatch, Slot::records) = records->range;
  return dispatch;
}

Result<void> ProjectedPlanner::planGroup(const Group& group, const BoundRange& sums) {
  const auto faces = bindFaces(group);
  if (!faces) return tl::unexpected(faces.error());
  const auto tasks = wholeSlice(addBlockTasks(group));
  if (!tasks) return tl::unexpected(tasks.error());
  const BoundRange blockSums = addPartials(group.blocks * sumsPerFace());
  const auto length = static_cast<std::uint64_t>(stage_.target().desc.length);

  Dispatch blocks = *faces;
  blocks.push.count = static_cast<std::uint32_t>(group.blocks);
  rangeOf(blocks, Slot::tasks) = tasks->range;
  rangeOf(blocks, Slot::target) = blockSums;
  if (auto shaped = stage_.shape(blocks, blocks.push.count * length); !shaped) return shaped;
  plan_.blocks.push_back(blocks);

  Dispatch totals = *faces;
  totals.kernel = Kernel::projectedSums;
  totals.push.count = static_cast<std::uint32_t>(group.faces.size());
  rangeOf(totals, Slot::target) = sums;
  rangeOf(totals, Slot::second) = blockSums;
  if (auto shaped = stage_.shape(totals, totals.push.count * 3 * length); !shaped) return shaped;
  plan_.sums.push_back(totals);
  return group.tasks > 0 ? planOutputs(group, *faces, sums) : Result<void>{};
}

Result<void> ProjectedPlanner::planOutputs(const Group& group, Dispatch dispatch, const BoundRange& sums) {
  const auto tasks = wholeSlice(addOutputTasks(group));
  if (!tasks) return tl::unexpected(tasks.error());
  dispatch.kernel = Kernel::projected;
  dispatch.push.count = static_cast<std::uint32_t>(group.tasks);
  rangeOf(dispatch, Slot::tasks) = tasks->range;
  rangeOf(dispatch, Slot::second) = sums;
  if (auto shaped = stage_.shape(dispatch, std::uint64_t{dispatch.push.count} * kWorkgroupSize); !shaped) return shaped;
  for (const Window& window : stage_.windows(stage_.target(), group.outputs.begin, group.outputs.end - 1)) {
    stage_.bindTarget(dispatch, window);
    plan_.outputs.push_back(dispatch);
  }
  return {};
}

}  // namespace

Result<ProjectedPlan> planProjected(const StagePlanner& stage, std::span<const ProjectedFace> faces,
                                    const Section& indices, const Section& weights, TableImage& image) {
  return ProjectedPlanner(stage, faces, indices, weights, image).plan();
}

}  // namespace honeycomb::Osd
