#include "osd/vulkan/plan.h"

#include <algorithm>

#include "osd/vulkan/projected_plan.h"
#include "osd/vulkan/summed_plan.h"

namespace honeycomb::Osd {

namespace {

static_assert(Far::kWidestDense <= kUnrolledSides, "the weights of dense rows are push constants");

using Far::LevelTable;

// The arrays of a level in the table's buffer.
struct LevelSections {
  Section indices, weights, outputs, offsets;
};

// A batch of items (faces of a circulant, dense rows) of one shape, which write one block of points after the other.
struct ItemBatch {
  Kernel kernel = Kernel::circulant;
  std::int64_t count = 0;
  std::int64_t firstIndex = 0;
  std::int64_t indices = 0;  // an item: sides, or the width of a row
  std::int64_t firstOutput = 0;
  std::int64_t outputs = 0;  // an item
  std::int64_t firstWeight = 0;
  std::int64_t weights = 0;
  Far::CirculantForm form = Far::CirculantForm::direct;
};

class LevelPlanner {
 public:
  LevelPlanner(const StagePlanner& stage, const LevelTable& table, const LevelSections& sections)
      : stage_(stage), table_(table), sections_(sections) {}

  Result<std::vector<Dispatch>> plan();

 private:
  Result<void> planBatch(const ItemBatch& batch);
  Result<void> planItems(const ItemBatch& batch, ItemRange range);
  Result<void> planLoose();
  Result<void> planRows(std::int64_t begin, std::int64_t end);

  const StagePlanner& stage_;
  const LevelTable& table_;
  LevelSections sections_;
  std::vector<Dispatch> dispatches_;
};

Result<std::vector<Dispatch>> LevelPlanner::plan() {
  for (const Far::CirculantBatch& b : table_.circulants) {
    const auto planned = planBatch({Kernel::circulant, b.faceCount, b.firstIndex, b.sides, b.firstOutput, b.sides,
                                    b.firstForm, b.formWeights(), b.form});
    if (!planned) return tl::unexpected(planned.error());
  }
  for (const Far::DenseRows& b : table_.dense) {
    const auto planned =
        planBatch({Kernel::dense, b.rowCount, b.firstIndex, b.width, b.firstOutput, 1, b.firstWeight, b.width});
    if (!planned) return tl::unexpected(planned.error());
  }
  if (const auto planned = planLoose(); !planned) return tl::unexpected(planned.error());
  return std::move(dispatches_);
}

Result<void> LevelPlanner::planBatch(const ItemBatch& batch) {
  const std::int64_t items = std::max<std::int64_t>(1, stage_.sliceCapacity(sections_.indices) / batch.indices);
  for (std::int64_t begin = 0; begin < batch.count; begin += items) {
    const ItemRange range{begin, std::min<std::int64_t>(begin + items, batch.count)};
    if (auto planned = planItems(batch, range); !planned) return planned;
  }
  return {};
}

Result<void> LevelPlanner::planItems(const ItemBatch& batch, ItemRange range) {
  const auto indices = stage_.slice(sections_.indices, batch.firstIndex + range.begin * batch.indices,
                                    (range.end - range.begin) * batch.indices);
  if (!indices) return tl::unexpected(indices.error());
  const auto weights = stage_.slice(sections_.weights, batch.firstWeight, batch.weights);
  if (!weights) return tl::unexpected(weights.error());
  const auto windows = stage_.windows(stage_.target(), batch.firstOutput + range.begin * batch.outputs,
                                      batch.firstOutput + range.end * batch.outputs - 1);
  for (const Window& window : windows) {
    const ItemRange items = stage_.itemsIn(window, {batch.firstOutput, batch.outputs}, range);
    if (items.begin >= items.end) continue;
    Dispatch dispatch = stage_.dispatch(batch.kernel);
    dispatch.specialization.sides = static_cast<std::uint32_t>(batch.indices);
    dispatch.push.count = static_cast<std::uint32_t>(items.end - items.begin);
    dispatch.push.firstIndex = indices->first + static_cast<std::uint32_t>((items.begin - range.begin) * batch.indices);
    dispatch.push.firstWeight = weights->first;
    dispatch.push.sides = static_cast<std::uint32_t>(batch.indices);
    dispatch.specialization.form = static_cast<std::uint32_t>(batch.form);
    if (batch.indices <= kUnrolledSides)
      std::copy_n(table_.weightsSingle.begin() + batch.firstWeight, batch.weights, dispatch.push.weights.begin());
    dispatch.push.firstOutput = static_cast<std::uint32_t>(batch.firstOutput + items.begin * batch.outputs);
    rangeOf(dispatch, Slot::indices) = indices->range;
    if (batch.kernel == Kernel::circulant) rangeOf(dispatch, Slot::weights) = weights->range;
    stage_.bindTarget(dispatch, window);
    if (auto shaped = stage_.shape(dispatch, dispatch.push.count); !shaped) return shaped;
    dispatches_.push_back(dispatch);
  }
  return {};
}

// As many rows as slices hold: of their entries, and of the rows themselves with the offset behind the last.
Result<void> LevelPlanner::planLoose() {
  const RowCapacity capacity{
      std::min(stage_.sliceCapacity(sections_.outputs), stage_.sliceCapacity(sections_.offsets) - 1),
      std::min(stage_.sliceCapacity(sections_.indices), stage_.sliceCapacity(sections_.weights))};
  for (std::int64_t begin = 0; begin < table_.loose.rowCount();) {
    const std::int64_t end = endOfRows(table_.loose.offsets, begin, capacity);
    if (auto planned = planRows(begin, end); !planned) return planned;
    begin = end;
  }
  return {};
}

Result<void> LevelPlanner::planRows(std::int64_t begin, std::int64_t end) {
  const Far::LooseRows& loose = table_.loose;
  const std::int64_t firstEntry = loose.offsets[static_cast<std::size_t>(begin)];
  const std::int64_t entries = loose.offsets[static_cast<std::size_t>(end)] - firstEntry;
  const auto indices = stage_.slice(sections_.indices, loose.firstIndex + firstEntry, entries);
  if (!indices) return tl::unexpected(indices.error());
  const auto weights = stage_.slice(sections_.weights, loose.firstWeight + firstEntry, entries);
  if (!weights) return tl::unexpected(weights.error());
  const auto outputs = stage_.slice(sections_.outputs, begin, end - begin);
  if (!outputs) return tl::unexpected(outputs.error());
  const auto offsets = stage_.slice(sections_.offsets, begin, end - begin + 1);
  if (!offsets) return tl::unexpected(offsets.error());
  const auto [lowest, highest] = std::minmax_element(loose.outputs.begin() + begin, loose.outputs.begin() + end);
  for (const Window& window : stage_.windows(stage_.target(), *lowest, *highest)) {
    Dispatch dispatch = stage_.dispatch(Kernel::loose);
    dispatch.push.count = static_cast<std::uint32_t>(end - begin);
    // The kernel adds the row's offset, which counts from the first entry of all rows: wraps round, as in the kernel.
    dispatch.push.firstIndex = indices->first - static_cast<std::uint32_t>(firstEntry);
    dispatch.push.firstWeight = weights->first - static_cast<std::uint32_t>(firstEntry);
    dispatch.push.firstRecord = outputs->first;
    dispatch.push.firstTask = offsets->first;
    rangeOf(dispatch, Slot::indices) = indices->range;
    rangeOf(dispatch, Slot::weights) = weights->range;
    rangeOf(dispatch, Slot::records) = outputs->range;
    rangeOf(dispatch, Slot::tasks) = offsets->range;
    stage_.bindTarget(dispatch, window);
    if (auto shaped = stage_.shape(dispatch, dispatch.push.count); !shaped) return shaped;
    dispatches_.push_back(dispatch);
  }
  return {};
}

}  // namespace

Result<StagePlan> planLevel(const VulkanLimits& limits, const LevelTable& table, const PointLayout& source,
                            const PointLayout& target, TableImage& image) {
  const StagePlanner stage(limits, source, target);
  if (const auto sound = stage.check(); !sound) return tl::unexpected(sound.error());
  const LevelSections sections{image.add(table.indices), image.add(table.weightsSingle), image.add(table.loose.outputs),
                               image.add(table.loose.offsets)};
  auto dispatches = LevelPlanner(stage, table, sections).plan();
  if (!dispatches) return tl::unexpected(dispatches.error());
  auto projected = planProjected(stage, table.projected, sections.indices, sections.weights, image);
  if (!projected) return tl::unexpected(projected.error());
  auto summed = planSummed(stage, table, sections.indices, sections.weights, *projected, image);
  if (!summed) return tl::unexpected(summed.error());

  StagePlan plan;
  plan.sourceBytes = stage.sourceBytes();
  plan.targetBytes = stage.targetBytes();
  plan.partialBytes = projected->partialBytes;
  dispatches->insert(dispatches->end(), projected->blocks.begin(), projected->blocks.end());
  plan.steps.push_back(std::move(*dispatches));
  if (!projected->blocks.empty()) {
    plan.steps.push_back(std::move(projected->sums));
    projected->outputs.insert(projected->outputs.end(), summed->begin(), summed->end());
    if (!projected->outputs.empty()) plan.steps.push_back(std::move(projected->outputs));
  }
  return plan;
}

}  // namespace honeycomb::Osd
