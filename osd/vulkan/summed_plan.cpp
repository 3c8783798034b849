#include "osd/vulkan/summed_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "far/base/index.h"

namespace honeycomb::Osd {

namespace {

// Entries of the tables in which rows and shares are described to the kernel.
constexpr std::int64_t kRowEntries = 3;
constexpr std::int64_t kShareEntries = 2;

class SummedPlanner {
 public:
  SummedPlanner(const StagePlanner& stage, const Far::LevelTable& table, const Section& indices, const Section& weights,
                const ProjectedPlan& projected, TableImage& image)
      : stage_(stage),
        table_(table),
        summed_(table.summed),
        indices_(indices),
        weights_(weights),
        projected_(projected),
        image_(image) {}

  Result<std::vector<Dispatch>> plan();

 private:
  std::int64_t endOfRows(std::int64_t begin) const;
  Result<void> planRows(std::int64_t begin, std::int64_t end);
  Result<Dispatch> bindRows(std::int64_t begin, std::int64_t end);
  Section addRows(std::int64_t begin, std::int64_t end);
  Section addShares(std::int64_t begin, std::int64_t end);
  std::int64_t entry(std::int64_t row) const { return summed_.rows.offsets[at(row)]; }
  std::int64_t share(std::int64_t row) const { return summed_.shareOffsets[at(row)]; }

  const StagePlanner& stage_;
  const Far::LevelTable& table_;
  const Far::SummedRows& summed_;
  Section indices_, weights_;
  const ProjectedPlan& projected_;
  TableImage& image_;
  std::vector<Dispatch> dispatches_;
};

Result<std::vector<Dispatch>> SummedPlanner::plan() {
  if (projected_.sumBytes > stage_.limits().pageBytes) {
    return fail(ErrorCode::tooLarge,
                fmt::format("the sums of {} large faces need {} bytes at once, this Vulkan device binds {}: use a CPU "
                            "backend",
                            projected_.sumNumbers.size(), projected_.sumBytes, stage_.limits().pageBytes));
  }
  for (std::int64_t begin = 0; begin < summed_.rowCount();) {
    const std::int64_t end = endOfRows(begin);
    if (auto planned = planRows(begin, end); !planned) return tl::unexpected(planned.error());
    begin = end;
  }
  return std::move(dispatches_);
}

// As many rows as slices and pages hold: of their entries, their shares, and themselves with the end behind the last.
std::int64_t SummedPlanner::endOfRows(std::int64_t begin) const {
  const auto page = static_cast<std::int64_t>(stage_.limits().pageNumbers());
  const std::int64_t entries = std::min(stage_.sliceCapacity(indices_), stage_.sliceCapacity(weights_));
  const std::int64_t rows = std::max<std::int64_t>(1, page / kRowEntries - 1);
  const std::int64_t limit = std::min<std::int64_t>(summed_.rowCount(), begin + rows);
  std::int64_t end = begin + 1;
  while (end < limit && entry(end + 1) - entry(begin) <= entries &&
         (share(end + 1) - share(begin)) * kShareEntries <= page) {
    ++end;
  }
  return end;
}

Section SummedPlanner::addRows(std::int64_t begin, std::int64_t end) {
  std::vector<std::uint32_t> records;
  for (std::int64_t r = begin; r <= end; ++r) {
    const std::int32_t output = r < end ? summed_.rows.outputs[at(r)] : 0;
    for (const std::int64_t number : {std::int64_t{output}, entry(r) - entry(begin), share(r) - share(begin)}) {
      records.push_back(static_cast<std::uint32_t>(number));
    }
  }
  return image_.add(std::move(records));
}

Section SummedPlanner::addShares(std::int64_t begin, std::int64_t end) {
  std::vector<std::uint32_t> shares;
  for (std::int64_t t = share(begin); t < share(end); ++t) {
    shares.push_back(projected_.sumNumbers[at(summed_.faces[at(t)])]);
    shares.push_back(std::bit_cast<std::uint32_t>(table_.weightsSingle[at(summed_.firstShare + t)]));
  }
  shares.resize(std::max<std::size_t>(shares.size(), kShareEntries));  // something can be bound where there are none
  return image_.add(std::move(shares));
}

Result<Dispatch> SummedPlanner::bindRows(std::int64_t begin, std::int64_t end) {
  const std::int64_t entries = entry(end) - entry(begin);
  const auto indices = stage_.slice(indices_, summed_.rows.firstIndex + entry(begin), entries);
  if (!indices) return tl::unexpected(indices.error());
  const auto weights = stage_.slice(weights_, summed_.rows.firstWeight + entry(begin), entries);
  if (!weights) return tl::unexpected(weights.error());
  const Section rows = addRows(begin, end);
  const auto records = stage_.slice(rows, 0, rows.count);
  if (!records) return tl::unexpected(records.error());
  const Section shares = addShares(begin, end);
  const auto tasks = stage_.slice(shares, 0, shares.count);
  if (!tasks) return tl::unexpected(tasks.error());
  Dispatch dispatch = stage_.dispatch(Kernel::summed);
  dispatch.push.count = static_cast<std::uint32_t>(end - begin);
  dispatch.push.firstIndex = indices->first;
  dispatch.push.firstWeight = weights->first;
  rangeOf(dispatch, Slot::indices) = indices->range;
  rangeOf(dispatch, Slot::weights) = weights->range;
  rangeOf(dispatch, Slot::records) = records->range;
  rangeOf(dispatch, Slot::tasks) = tasks->range;
  rangeOf(dispatch, Slot::second) = {Role::partials, 0, projected_.sumBytes};
  return dispatch;
}

Result<void> SummedPlanner::planRows(std::int64_t begin, std::int64_t end) {
  auto dispatch = bindRows(begin, end);
  if (!dispatch) return tl::unexpected(dispatch.error());
  if (auto shaped = stage_.shape(*dispatch, dispatch->push.count); !shaped) return shaped;
  const auto& outputs = summed_.rows.outputs;
  const auto [lowest, highest] = std::minmax_element(outputs.begin() + begin, outputs.begin() + end);
  for (const Window& window : stage_.windows(stage_.target(), *lowest, *highest)) {
    stage_.bindTarget(*dispatch, window);
    dispatches_.push_back(*dispatch);
  }
  return {};
}

}  // namespace

Result<std::vector<Dispatch>> planSummed(const StagePlanner& stage, const Far::LevelTable& table,
                                         const Section& indices, const Section& weights, const ProjectedPlan& projected,
                                         TableImage& image) {
  return SummedPlanner(stage, table, indices, weights, projected, image).plan();
}

}  // namespace honeycomb::Osd
