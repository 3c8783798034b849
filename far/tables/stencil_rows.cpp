#include "far/tables/stencil_rows.h"

#include <algorithm>
#include <atomic>

#include "far/base/parallel.h"

namespace honeycomb::Far {

namespace {

/// Rows below which a piece isn't cut again: each piece has marker arrays as wide as all levels, cleared once.
constexpr std::int64_t kStencilRowsPerPiece = 512;
/// Pieces a thread: enough to level out rows of different cost, few enough for the marker arrays.
constexpr std::int64_t kPiecesPerThread = 4;

/// Calls body(begin, end) on pieces of [0, rows).
template <class Body>
void forPieces(std::int64_t rows, const Body& body) {
  const std::int64_t pieces = kPiecesPerThread * Parallel::threadCount();
  Parallel::forRange(0, rows, std::max(kStencilRowsPerPiece, rows / pieces), body);
}

}  // namespace

FrameIndex::FrameIndex(const LimitRows& rows) : rows_(rows), place_(at(rows.elementCount), -1) {
  Parallel::forEach(0, static_cast<std::int64_t>(rows.elements.size()),
                    [&](std::int64_t i) { place_[at(rows.elements[at(i)])] = static_cast<std::int32_t>(i); });
}

const FrameBatch& FrameIndex::batchOf(std::int32_t element) const {
  const auto after = std::upper_bound(rows_.batches.begin(), rows_.batches.end(), place_[at(element)],
                                      [](std::int32_t p, const FrameBatch& b) { return p < b.firstElement; });
  return *std::prev(after);
}

std::span<const std::int32_t> FrameIndex::points(std::int32_t element) const {
  const FrameBatch& batch = batchOf(element);
  const std::int64_t before = std::int64_t{place_[at(element)] - batch.firstElement} * batch.sides;
  return std::span(rows_.indices).subspan(at(batch.firstIndex + before), at(batch.sides));
}

bool countEntries(const StencilStart& start, std::span<const std::int32_t> outputs, std::int64_t most,
                  StencilEntries& entries) {
  std::vector<std::int32_t>& counts = entries.offsets;
  counts.assign(outputs.size() + 1, 0);
  std::atomic<std::int64_t> total{0};
  forPieces(static_cast<std::int64_t>(outputs.size()), [&](std::int64_t begin, std::int64_t end) {
    Composer<0> composer(start.chain());
    for (std::int64_t r = begin; r < end; ++r) {
      if (r > begin && start.sameSupport(outputs[at(r)], outputs[at(r) - 1])) {
        counts[at(r)] = counts[at(r) - 1];
      } else {
        start.start(composer, outputs[at(r)]);
        counts[at(r)] = static_cast<std::int32_t>(composer.compose().touched().size());
        composer.clear();
      }
      if (total.fetch_add(counts[at(r)], std::memory_order_relaxed) + counts[at(r)] > most) return;
    }
  });
  if (total > most) return false;
  Parallel::exclusiveScan(counts);
  return true;
}

template <std::size_t Lanes>
void fillEntries(const StencilStart& start, std::span<const std::int32_t> outputs, StencilEntries& entries,
                 const std::array<std::vector<double>*, Lanes>& lanes) {
  entries.indices.resize(at(entries.offsets.back()));
  for (std::vector<double>* lane : lanes) lane->resize(entries.indices.size());
  forPieces(static_cast<std::int64_t>(outputs.size()), [&](std::int64_t begin, std::int64_t end) {
    Composer<Lanes> composer(start.chain());
    std::vector<std::int32_t> points;
    for (std::int64_t r = begin; r < end; ++r) {
      start.start(composer, outputs[at(r)]);
      const SparsePoints<Lanes>& sums = composer.compose();
      if (r == begin || !start.sameSupport(outputs[at(r)], outputs[at(r) - 1])) {
        points = sums.touched();
        std::sort(points.begin(), points.end());
      }
      std::size_t entry = at(entries.offsets[at(r)]);
      for (const std::int32_t point : points) {
        entries.indices[entry] = point;
        for (std::size_t lane = 0; lane < Lanes; ++lane) (*lanes[lane])[entry] = sums.weights(point)[lane];
        ++entry;
      }
      composer.clear();
    }
  });
}

template void fillEntries(const StencilStart&, std::span<const std::int32_t>, StencilEntries&,
                          const std::array<std::vector<double>*, 1>&);
template void fillEntries(const StencilStart&, std::span<const std::int32_t>, StencilEntries&,
                          const std::array<std::vector<double>*, 3>&);

}  // namespace honeycomb::Far
