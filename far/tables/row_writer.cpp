#include "far/tables/row_writer.h"

#include <algorithm>
#include <atomic>

#include "far/base/index.h"
#include "far/base/parallel.h"

namespace honeycomb::Far {

namespace {

/// Rows computed by one task: some hundred microseconds.
constexpr std::int64_t kRowsPerPiece = 2048;

/// More runs than this in a block would be more dispatches than the weights saved are worth.
constexpr std::int64_t kMostRuns = 16;

bool sameWeights(const Row& row, const double* weights, std::int32_t width) {
  return row.size() == at(width) && std::equal(row.begin(), row.end(), weights, [](const Weight& entry, double weight) {
           return entry.weight == weight;
         });
}

/// The runs of equal weights in a piece of a block.
struct Piece {
  struct Run {
    std::int64_t begin;
    std::int32_t width;
    std::size_t firstWeight;
  };
  std::vector<Run> runs;
  std::vector<double> weights;

  void add(std::int64_t i, const Row& row) {
    if (!runs.empty() && sameWeights(row, weights.data() + runs.back().firstWeight, runs.back().width)) return;
    runs.push_back({i, static_cast<std::int32_t>(row.size()), weights.size()});
    for (const Weight& entry : row) weights.push_back(entry.weight);
  }
};

/// Calls visit(i, row) for the rows of a piece, in order.
template <class Visit>
void visitRows(std::int64_t begin, std::int64_t end, const RowWriter::MakeRow& makeRow, const Visit& visit) {
  Row row;
  for (std::int64_t i = begin; i < end; ++i) {
    row.clear();
    makeRow(i, row);
    visit(i, row);
  }
}

std::vector<Piece> survey(std::int64_t count, const RowWriter::MakeRow& makeRow) {
  std::vector<Piece> pieces(at((count + kRowsPerPiece - 1) / kRowsPerPiece));
  Parallel::forEach(
      0, static_cast<std::int64_t>(pieces.size()),
      [&](std::int64_t p) {
        visitRows(p * kRowsPerPiece, std::min(count, (p + 1) * kRowsPerPiece), makeRow,
                  [&](std::int64_t i, const Row& row) { pieces[at(p)].add(i, row); });
      },
      1);
  return pieces;
}

}  // namespace

void RowWriter::add(std::int32_t firstOutput, std::int64_t count, const MakeRow& makeRow) {
  if (count == 0 || addUniform(firstOutput, count, makeRow)) return;
  const std::vector<Piece> pieces = survey(count, makeRow);
  std::vector<Run> runs;
  for (const Piece& piece : pieces) {
    for (const Piece::Run& run : piece.runs) {
      const double* weights = piece.weights.data() + run.firstWeight;
      const bool same = !runs.empty() && runs.back().width == run.width &&
                        std::equal(weights, weights + run.width, runs.back().weights);
      if (!same) runs.push_back({run.begin, count, weights, run.width});
      if (!same && runs.size() > 1) runs[runs.size() - 2].end = run.begin;
    }
  }
  place(runs, count, firstOutput);
  write(runs, count, firstOutput, makeRow);
}

/// Writes the rows as one batch if their weights are equal, which it finds out on the way: as they nearly always are
/// where the first and the last row's are.
bool RowWriter::addUniform(std::int32_t firstOutput, std::int64_t count, const MakeRow& makeRow) {
  Row first;
  Row last;
  makeRow(0, first);
  makeRow(count - 1, last);
  std::vector<double> weights;
  for (const Weight& entry : first) weights.push_back(entry.weight);
  const auto width = static_cast<std::int32_t>(weights.size());
  if (count < kShortestDense || width > kWidestDense || !sameWeights(last, weights.data(), width)) return false;
  const std::size_t firstIndex = table_.indices.size();
  Array<std::int32_t>& indices = table_.indices.edit();
  indices.resize(firstIndex + at(count) * at(width));
  std::atomic<bool> uniform{true};
  Parallel::forRange(0, count, kRowsPerPiece, [&](std::int64_t begin, std::int64_t end) {
    std::int32_t* index = indices.data() + firstIndex + at(begin) * at(width);
    bool same = true;
    visitRows(begin, end, makeRow, [&](std::int64_t, const Row& row) {
      same = same && sameWeights(row, weights.data(), width);
      if (!same) return;
      for (const Weight& entry : row) *index++ = entry.point;
    });
    if (!same) uniform.store(false, std::memory_order_relaxed);
  });
  indices.resize(firstIndex + (uniform ? at(count) * at(width) : 0));
  if (uniform) addDense({0, count, weights.data(), width, true, firstIndex, 0}, firstOutput);
  return uniform;
}

void RowWriter::addDense(const Run& run, std::int32_t firstOutput) {
  table_.dense.push_back({run.width, static_cast<std::int32_t>(run.end - run.begin),
                          static_cast<std::int32_t>(run.firstIndex), firstOutput + static_cast<std::int32_t>(run.begin),
                          static_cast<std::int32_t>(table_.weights.size())});
  table_.weights.append(run.weights, run.weights + run.width);
}

/// Decides which runs are dense, and makes room for all.
void RowWriter::place(std::vector<Run>& runs, std::int64_t count, std::int32_t firstOutput) {
  const std::int64_t shortest = std::max<std::int64_t>(kShortestDense, count / kMostRuns);
  std::size_t denseIndices = table_.indices.size();
  std::size_t looseIndices = looseIndices_.size();
  std::size_t looseRows = table_.loose.outputs.size();
  for (Run& run : runs) {
    const std::size_t rows = at(run.end - run.begin);
    run.dense = run.end - run.begin >= shortest && run.width <= kWidestDense;
    std::size_t& indices = run.dense ? denseIndices : looseIndices;
    run.firstIndex = indices;
    run.firstRow = looseRows;
    indices += rows * at(run.width);
    if (run.dense) {
      addDense(run, firstOutput);
    } else {
      looseRows += rows;
    }
  }
  table_.indices.edit().resize(denseIndices);
  table_.loose.outputs.resize(looseRows);
  table_.loose.offsets.resize(looseRows + 1);
  looseIndices_.resize(looseIndices);
  looseWeights_.resize(looseIndices);
}

void RowWriter::write(const std::vector<Run>& runs, std::int64_t count, std::int32_t firstOutput,
                      const MakeRow& makeRow) {
  Array<std::int32_t>& indices = table_.indices.edit();
  Parallel::forRange(0, count, kRowsPerPiece, [&](std::int64_t begin, std::int64_t end) {
    auto run = std::prev(std::upper_bound(runs.begin(), runs.end(), begin,
                                          [](std::int64_t row, const Run& r) { return row < r.begin; }));
    visitRows(begin, end, makeRow, [&](std::int64_t i, const Row& row) {
      while (i >= run->end) ++run;
      const std::int64_t r = i - run->begin;
      if (!run->dense) return writeLoose(*run, r, row, firstOutput + static_cast<std::int32_t>(i));
      std::int32_t* index = indices.data() + run->firstIndex + at(r) * at(run->width);
      for (const Weight& entry : row) *index++ = entry.point;
    });
  });
}

void RowWriter::writeLoose(const Run& run, std::int64_t row, const Row& entries, std::int32_t output) {
  std::size_t entry = run.firstIndex + at(row) * at(run.width);
  for (const Weight& e : entries) {
    looseIndices_[entry] = e.point;
    looseWeights_[entry++] = e.weight;
  }
  table_.loose.outputs[run.firstRow + at(row)] = output;
  table_.loose.offsets[run.firstRow + at(row) + 1] = static_cast<std::int32_t>(entry);
}

void RowWriter::finish() {
  table_.loose.firstIndex = static_cast<std::int32_t>(table_.indices.size());
  table_.loose.firstWeight = static_cast<std::int32_t>(table_.weights.size());
  if (looseIndices_.empty()) return;
  table_.indices.edit().append(looseIndices_.begin(), looseIndices_.end());
  table_.weights.append(looseWeights_.begin(), looseWeights_.end());
}

}  // namespace honeycomb::Far
