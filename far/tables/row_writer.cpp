#include "far/tables/row_writer.h"

#include <algorithm>

#include "far/base/index.h"
#include "far/base/parallel.h"

namespace honeycomb::Far {

namespace {

/// Rows computed by one task: some hundred microseconds.
constexpr std::int64_t kRowsPerPiece = 2048;

/// More runs than this in a block would be more dispatches than the weights saved are worth.
constexpr std::int64_t kMostRuns = 16;

}  // namespace

std::int64_t RowWriter::Block::width(std::int64_t row) const {
  return offsets[at(row) + 1] - offsets[at(row)];
}

bool RowWriter::Block::sameWeights(std::int64_t a, std::int64_t b) const {
  return width(a) == width(b) && std::equal(weights.begin() + offsets[at(a)], weights.begin() + offsets[at(a) + 1],
                                            weights.begin() + offsets[at(b)]);
}

RowWriter::Block RowWriter::compute(std::int64_t count, const MakeRow& makeRow) {
  const std::int64_t pieceCount = (count + kRowsPerPiece - 1) / kRowsPerPiece;
  std::vector<Block> pieces(at(pieceCount));
  Parallel::forEach(
      0, pieceCount,
      [&](std::int64_t p) {
        Block& piece = pieces[at(p)];
        Row row;
        for (std::int64_t i = p * kRowsPerPiece; i < std::min(count, (p + 1) * kRowsPerPiece); ++i) {
          row.clear();
          makeRow(i, row);
          for (const Weight& entry : row) {
            piece.indices.push_back(entry.point);
            piece.weights.push_back(entry.weight);
          }
          piece.offsets.push_back(static_cast<std::int64_t>(piece.indices.size()));
        }
      },
      1);
  if (pieceCount == 1) return std::move(pieces.front());
  Block block;
  block.offsets.reserve(at(count) + 1);
  for (const Block& piece : pieces) {
    const std::int64_t base = block.offsets.back();
    for (std::size_t r = 1; r < piece.offsets.size(); ++r) block.offsets.push_back(base + piece.offsets[r]);
    block.indices.insert(block.indices.end(), piece.indices.begin(), piece.indices.end());
    block.weights.insert(block.weights.end(), piece.weights.begin(), piece.weights.end());
  }
  return block;
}

void RowWriter::add(std::int32_t firstOutput, std::int64_t count, const MakeRow& makeRow) {
  const Block block = compute(count, makeRow);
  const std::int64_t shortest = std::max<std::int64_t>(kShortestDense, count / kMostRuns);
  std::int64_t loose = 0;  // first row not written yet
  for (std::int64_t begin = 0; begin < count;) {
    std::int64_t end = begin + 1;
    while (end < count && block.sameWeights(begin, end)) ++end;
    if (end - begin >= shortest && block.width(begin) <= kWidestDense) {
      addLoose(block, loose, begin, firstOutput);
      addDense(block, begin, end, firstOutput);
      loose = end;
    }
    begin = end;
  }
  addLoose(block, loose, count, firstOutput);
}

void RowWriter::addDense(const Block& block, std::int64_t begin, std::int64_t end, std::int32_t firstOutput) {
  const std::int64_t from = block.offsets[at(begin)];
  const std::int64_t width = block.width(begin);
  table_.dense.push_back({static_cast<std::int32_t>(width), static_cast<std::int32_t>(end - begin),
                          static_cast<std::int32_t>(table_.indices.size()),
                          firstOutput + static_cast<std::int32_t>(begin),
                          static_cast<std::int32_t>(table_.weights.size())});
  table_.indices.insert(table_.indices.end(), block.indices.begin() + from,
                        block.indices.begin() + block.offsets[at(end)]);
  table_.weights.insert(table_.weights.end(), block.weights.begin() + from, block.weights.begin() + from + width);
}

void RowWriter::addLoose(const Block& block, std::int64_t begin, std::int64_t end, std::int32_t firstOutput) {
  LooseRows& loose = table_.loose;
  const std::int32_t base = loose.offsets.back() - static_cast<std::int32_t>(block.offsets[at(begin)]);
  for (std::int64_t r = begin; r < end; ++r) {
    loose.outputs.push_back(firstOutput + static_cast<std::int32_t>(r));
    loose.offsets.push_back(base + static_cast<std::int32_t>(block.offsets[at(r) + 1]));
  }
  looseIndices_.insert(looseIndices_.end(), block.indices.begin() + block.offsets[at(begin)],
                       block.indices.begin() + block.offsets[at(end)]);
  looseWeights_.insert(looseWeights_.end(), block.weights.begin() + block.offsets[at(begin)],
                       block.weights.begin() + block.offsets[at(end)]);
}

void RowWriter::finish() {
  table_.loose.firstIndex = static_cast<std::int32_t>(table_.indices.size());
  table_.loose.firstWeight = static_cast<std::int32_t>(table_.weights.size());
  table_.indices.insert(table_.indices.end(), looseIndices_.begin(), looseIndices_.end());
  table_.weights.insert(table_.weights.end(), looseWeights_.begin(), looseWeights_.end());
}

}  // namespace honeycomb::Far
