#include "far/tables/summed_row_writer.h"

#include <algorithm>

#include "far/base/index.h"
#include "far/base/parallel.h"

namespace honeycomb::Far {

void SummedRowWriter::add(std::int32_t firstOutput, std::int64_t count, const RowWriter::MakeRow& makeRow) {
  // Rows held at once: some megabytes.
  constexpr std::int64_t kHeld = 1 << 14;
  std::vector<Row> rows(at(std::min(count, kHeld)));
  for (std::int64_t first = 0; first < count; first += kHeld) {
    const std::int64_t held = std::min(kHeld, count - first);
    Parallel::forEach(
        0, held,
        [&](std::int64_t i) {
          rows[at(i)].clear();
          makeRow(first + i, rows[at(i)]);
        },
        256);
    for (std::int64_t i = 0; i < held; ++i) append(firstOutput + static_cast<std::int32_t>(first + i), rows[at(i)]);
  }
}

void SummedRowWriter::append(std::int32_t output, const Row& row) {
  SummedRows& summed = table_.summed;
  for (const Weight& entry : row) {
    if (entry.point < table_.sourceCount) {
      indices_.push_back(entry.point);
      weights_.push_back(entry.weight);
    } else {
      summed.faces.push_back(entry.point - table_.sourceCount);
      shares_.push_back(entry.weight);
    }
  }
  summed.rows.outputs.push_back(output);
  summed.rows.offsets.push_back(static_cast<std::int32_t>(indices_.size()));
  summed.shareOffsets.push_back(static_cast<std::int32_t>(summed.faces.size()));
}

void SummedRowWriter::finish() {
  table_.summed.rows.firstIndex = static_cast<std::int32_t>(table_.indices.size());
  table_.summed.rows.firstWeight = static_cast<std::int32_t>(table_.weights.size());
  if (!indices_.empty()) table_.indices.edit().append(indices_.begin(), indices_.end());
  table_.weights.append(weights_.begin(), weights_.end());
  table_.summed.firstShare = static_cast<std::int32_t>(table_.weights.size());
  table_.weights.append(shares_.begin(), shares_.end());
}

}  // namespace honeycomb::Far
