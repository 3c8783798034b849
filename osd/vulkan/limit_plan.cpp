#include <algorithm>

#include "osd/vulkan/plan.h"

namespace honeycomb::Osd {

namespace {

using Far::FrameBatch;

struct LimitSections {
  Section indices, weights, elements;
};

class LimitPlanner {
 public:
  LimitPlanner(const StagePlanner& positions, const StagePlanner& normals, const LimitLayouts& layouts,
               const Far::LimitRows& rows, const LimitSections& sections)
      : positions_(positions), normals_(normals), layouts_(layouts), rows_(rows), sections_(sections) {}

  Result<std::vector<Dispatch>> plan();

 private:
  void setResults(Dispatch& dispatch) const;
  Result<void> planElements(const FrameBatch& batch, std::int64_t begin, std::int64_t end);
  std::vector<Window> windows(const StagePlanner& stage, bool wanted, std::int64_t begin, std::int64_t end) const;
  void addDispatches(const Dispatch& dispatch, const std::vector<Window>& positions,
                     const std::vector<Window>& normals);

  const StagePlanner& positions_;
  const StagePlanner& normals_;
  const LimitLayouts& layouts_;
  const Far::LimitRows& rows_;
  LimitSections sections_;
  std::vector<Dispatch> dispatches_;
};

Result<std::vector<Dispatch>> LimitPlanner::plan() {
  for (const FrameBatch& batch : rows_.batches) {
    const std::int64_t most =
        std::max<std::int64_t>(1, std::min(positions_.sliceCapacity(sections_.indices) / std::max(1, batch.sides),
                                           positions_.sliceCapacity(sections_.elements)));
    for (std::int64_t begin = 0; begin < batch.count; begin += most) {
      const std::int64_t end = std::min<std::int64_t>(begin + most, batch.count);
      if (const auto planned = planElements(batch, begin, end); !planned) return tl::unexpected(planned.error());
    }
  }
  return std::move(dispatches_);
}

std::vector<Window> LimitPlanner::windows(const StagePlanner& stage, bool wanted, std::int64_t begin,
                                          std::int64_t end) const {
  if (!wanted) return {};
  const auto [lowest, highest] = std::minmax_element(rows_.elements.begin() + begin, rows_.elements.begin() + end);
  return stage.windows(stage.target(), *lowest, *highest);
}

// The constants that the wanted results determine; a stride of 0 stands for a result that isn't wanted.
void LimitPlanner::setResults(Dispatch& dispatch) const {
  Specialization& constants = dispatch.specialization;
  constants.normalStride = static_cast<std::uint32_t>(normals_.target().desc.stride);
  if (!layouts_.positions) constants.targetStride = 0;
  if (!layouts_.normals) constants.normalStride = 0;
  const std::uint64_t largest =
      std::max(layouts_.positions ? positions_.targetBytes() : 0, layouts_.normals ? normals_.targetBytes() : 0);
  constants.windowed = largest <= positions_.limits().pageBytes ? 0 : 1;
  dispatch.push.normalOffset = static_cast<std::uint32_t>(normals_.target().desc.offset);
}

Result<void> LimitPlanner::planElements(const FrameBatch& batch, std::int64_t begin, std::int64_t end) {
  const std::int64_t sides = batch.sides;
  const auto indices = positions_.slice(sections_.indices, batch.firstIndex + begin * sides, (end - begin) * sides);
  if (!indices) return tl::unexpected(indices.error());
  const auto weights = positions_.slice(sections_.weights, batch.firstWeight, 3 * sides);
  if (!weights) return tl::unexpected(weights.error());
  const auto elements = positions_.slice(sections_.elements, batch.firstElement + begin, end - begin);
  if (!elements) return tl::unexpected(elements.error());
  Dispatch dispatch = positions_.dispatch(Kernel::limits);
  setResults(dispatch);
  dispatch.specialization.sides = sides <= kUnrolledSides ? static_cast<std::uint32_t>(sides) : 0;
  dispatch.push.sides = static_cast<std::uint32_t>(sides);
  dispatch.push.count = static_cast<std::uint32_t>(end - begin);
  dispatch.push.firstIndex = indices->first;
  dispatch.push.firstWeight = weights->first;
  dispatch.push.firstRecord = elements->first;
  rangeOf(dispatch, Slot::indices) = indices->range;
  rangeOf(dispatch, Slot::weights) = weights->range;
  rangeOf(dispatch, Slot::records) = elements->range;
  if (auto shaped = positions_.shape(dispatch, dispatch.push.count); !shaped) return shaped;
  const std::int64_t first = batch.firstElement + begin, past = batch.firstElement + end;
  addDispatches(dispatch, windows(positions_, layouts_.positions.has_value(), first, past),
                windows(normals_, layouts_.normals.has_value(), first, past));
  return {};
}

// Window k of the positions goes with window k of the normals; an element whose results lie in two different ones is
// computed for each. A result without a window k is bound to the other's, of which it may write nothing.
void LimitPlanner::addDispatches(const Dispatch& dispatch, const std::vector<Window>& positions,
                                 const std::vector<Window>& normals) {
  for (std::size_t w = 0; w < std::max(positions.size(), normals.size()); ++w) {
    Dispatch one = dispatch;
    if (w < positions.size()) positions_.bindTarget(one, positions[w]);
    if (w < normals.size()) {
      rangeOf(one, Slot::second) = {Role::normals, normals[w].begin * sizeof(float), normals[w].size * sizeof(float)};
      one.push.normalBegin = static_cast<std::uint32_t>(normals[w].begin);
      one.push.normalSize = static_cast<std::uint32_t>(normals[w].size);
    }
    if (w >= positions.size()) rangeOf(one, Slot::target) = rangeOf(one, Slot::second);
    if (w >= normals.size()) rangeOf(one, Slot::second) = rangeOf(one, Slot::target);
    dispatches_.push_back(one);
  }
}

}  // namespace

Result<StagePlan> planLimits(const VulkanLimits& limits, const Far::LimitRows& rows, const PointLayout& source,
                             const LimitLayouts& layouts, std::int64_t results, TableImage& image) {
  const StagePlanner positions(limits, source, {layouts.positions.value_or(BufferDescriptor{}), results});
  const StagePlanner normals(limits, source, {layouts.normals.value_or(BufferDescriptor{}), results});
  if (const auto sound = positions.check(); !sound) return tl::unexpected(sound.error());
  if (const auto sound = normals.check(); !sound) return tl::unexpected(sound.error());
  const LimitSections sections{image.add(rows.indices), image.add(rows.weightsSingle), image.add(rows.elements)};
  auto dispatches = LimitPlanner(positions, normals, layouts, rows, sections).plan();
  if (!dispatches) return tl::unexpected(dispatches.error());
  StagePlan plan;
  plan.sourceBytes = positions.sourceBytes();
  plan.targetBytes = layouts.positions ? positions.targetBytes() : 0;
  plan.normalBytes = layouts.normals ? normals.targetBytes() : 0;
  plan.steps.push_back(std::move(*dispatches));
  return plan;
}

}  // namespace honeycomb::Osd
