#include "far/tables/stencil_chain.h"

#include <algorithm>
#include <atomic>

#include "far/base/parallel.h"

namespace honeycomb::Far {

namespace {

/// A set of points that many threads add to.
class PointSet {
 public:
  explicit PointSet(std::int32_t pointCount) : marked_(at(pointCount), 0) {}

  void add(std::int32_t point) { std::atomic_ref(marked_[at(point)]).store(1, std::memory_order_relaxed); }

  /// Ascending.
  std::vector<std::int32_t> points() const {
    std::vector<std::int32_t> places(marked_);
    std::vector<std::int32_t> list(at(Parallel::exclusiveScan(places)));
    Parallel::forEach(0, static_cast<std::int64_t>(marked_.size()), [&](std::int64_t i) {
      if (marked_[at(i)] != 0) list[at(places[at(i)])] = static_cast<std::int32_t>(i);
    });
    return list;
  }

 private:
  std::vector<std::int32_t> marked_;
};

/// The sources of the rows of some targets of a table.
std::vector<std::int32_t> sourcesOf(const LevelRows& rows, std::span<const std::int32_t> targets) {
  PointSet sources(rows.table().sourceCount);
  Parallel::forEach(0, static_cast<std::int64_t>(targets.size()), [&](std::int64_t i) {
    rows.visit(targets[at(i)], [&](std::int32_t source, double) { sources.add(source); });
  });
  return sources.points();
}

}  // namespace

StencilChain::StencilChain(std::span<const LevelTable* const> tables, std::span<const FrameIndex> frames)
    : frames_(frames) {
  rows_.reserve(tables.size());
  for (const LevelTable* table : tables) rows_.emplace_back(*table);
  for (const LevelRows& rows : rows_) chain_.push_back(&rows);
}

bool StencilChain::foldable() const {
  return std::ranges::all_of(chain_, [](const LevelRows* rows) {
    return std::ranges::all_of(rows->table().projected,
                               [](const ProjectedFace& face) { return face.corners <= kLargestFolded; });
  });
}

/// The targets of the second table that the outputs are made of.
std::vector<std::int32_t> StencilChain::needed(std::span<const std::int32_t> outputs) const {
  if (frames_.empty()) return sourcesOf(*chain_.front(), outputs);
  PointSet top(chain_[0]->rowCount());
  PointSet below(chain_[1]->rowCount());
  Parallel::forEach(0, static_cast<std::int64_t>(outputs.size()), [&](std::int64_t i) {
    const std::size_t step = frames_.front().has(outputs[at(i)]) ? 0 : 1;
    for (const std::int32_t point : frames_[step].points(outputs[at(i)])) (step == 0 ? top : below).add(point);
  });
  for (const std::int32_t point : sourcesOf(*chain_.front(), top.points())) below.add(point);
  return below.points();
}

bool StencilChain::fold(std::span<const std::int32_t> outputs, std::int64_t most) {
  if (chain_.size() < 3 || !foldable()) return true;
  // What each table has to give, from the second down; then composed from the bottom up.
  std::vector<std::vector<std::int32_t>> targets{needed(outputs)};
  for (std::size_t step = 1; step + 2 < chain_.size(); ++step) {
    targets.push_back(sourcesOf(*chain_[step], targets.back()));
  }
  const LevelRows* below = chain_.back();
  for (std::size_t step = chain_.size() - 2; step >= 1; --step) {
    const LevelRows* pair[] = {chain_[step], below};
    const StencilStart start(pair);
    StencilEntries entries;
    LevelTable folded;
    folded.sourceCount = chain_.back()->table().sourceCount;
    folded.targetCount = chain_[step]->rowCount();
    const std::vector<std::int32_t>& target = targets[step - 1];
    if (!countEntries(start, target, most, entries)) return false;
    std::vector<double> weights;
    fillEntries<1>(start, target, entries, {&weights});
    folded.loose.outputs.assign(target.begin(), target.end());
    folded.loose.offsets.assign(entries.offsets.begin(), entries.offsets.end());
    folded.weights.assign(weights.begin(), weights.end());
    folded.indices = std::move(entries.indices);
    folded_ = std::move(folded);
    foldedRows_ = std::make_unique<LevelRows>(folded_);
    below = foldedRows_.get();
  }
  chain_ = {chain_.front(), below};
  return true;
}

}  // namespace honeycomb::Far
