#include "far/tables/replaced_rows.h"

#include <algorithm>
#include <utility>

#include "far/base/index.h"
#include "far/tables/summed_row_writer.h"

namespace honeycomb::Far {

namespace {

class Replacement {
 public:
  Replacement(LevelTable& table, const RowChanges& changes)
      : table_(table), changes_(changes), goes_(at(table.targetCount), 0) {
    for (const ReplacedRow& row : changes.rows) goes_[at(row.output)] = 1;
  }

  void apply() {
    cutCirculants();
    cutDense();
    cutProjected();
    cutLoose();
    const std::vector<ReplacedRow> keptSummed = cutSummed();
    addSums();
    addRows(keptSummed);
    dropUnread();
    table_.weightsSingle.assign(table_.weights.begin(), table_.weights.end());
  }

 private:
  /// Calls keep(first, count) for the runs of items that stay; item i writes from firstOutput + i * outputs.
  template <class Keep>
  void visitRuns(std::int32_t firstOutput, std::int32_t items, std::int32_t outputs, const Keep& keep) const {
    std::int32_t first = 0;
    for (std::int32_t i = 0; i <= items; ++i) {
      if (i < items && goes_[at(firstOutput + i * outputs)] == 0) continue;
      if (i > first) keep(first, i - first);
      first = i + 1;
    }
  }

  void cutCirculants() {
    const std::vector<CirculantBatch> batches = std::exchange(table_.circulants, {});
    for (const CirculantBatch& batch : batches) {
      visitRuns(batch.firstOutput, batch.faceCount, batch.sides, [&](std::int32_t first, std::int32_t count) {
        CirculantBatch part = batch;
        part.faceCount = count;
        part.firstIndex += first * batch.sides;
        part.firstOutput += first * batch.sides;
        table_.circulants.push_back(part);
      });
    }
  }

  void cutDense() {
    const std::vector<DenseRows> batches = std::exchange(table_.dense, {});
    for (const DenseRows& batch : batches) {
      visitRuns(batch.firstOutput, batch.rowCount, 1, [&](std::int32_t first, std::int32_t count) {
        DenseRows part = batch;
        part.rowCount = count;
        part.firstIndex += first * batch.width;
        part.firstOutput += first;
        table_.dense.push_back(part);
      });
    }
  }

  /// Faces whose outputs are replaced stay, without outputs, for the rows that read their sums.
  void cutProjected() {
    for (ProjectedFace& face : table_.projected) {
      if (face.outputs > 0 && goes_[at(face.firstOutput)] != 0) face.outputs = 0;
    }
  }

  /// Takes the loose rows that stay out of the table.
  void cutLoose() {
    const LooseRows old = std::exchange(table_.loose, {});
    for (std::int32_t r = 0; r < old.rowCount(); ++r) {
      if (goes_[at(old.outputs[at(r)])] != 0) continue;
      for (std::int32_t b = old.offsets[at(r)]; b < old.offsets[at(r) + 1]; ++b) {
        looseIndices_.push_back(table_.indices[at(old.firstIndex + b)]);
        looseWeights_.push_back(table_.weights[at(old.firstWeight + b)]);
      }
      closeLoose(old.outputs[at(r)]);
    }
    table_.indices.edit().resize(at(old.firstIndex));
    table_.weights.resize(at(old.firstWeight));
  }

  void closeLoose(std::int32_t output) {
    table_.loose.outputs.push_back(output);
    table_.loose.offsets.push_back(static_cast<std::int32_t>(looseIndices_.size()));
  }

  /// Takes the summed rows out of the table; returns those that stay.
  std::vector<ReplacedRow> cutSummed() {
    const SummedRows old = std::exchange(table_.summed, {});
    std::vector<ReplacedRow> kept;
    for (std::int32_t r = 0; r < old.rowCount(); ++r) {
      if (goes_[at(old.rows.outputs[at(r)])] != 0) continue;
      ReplacedRow& row = kept.emplace_back();
      row.output = old.rows.outputs[at(r)];
      for (std::int32_t b = old.rows.offsets[at(r)]; b < old.rows.offsets[at(r) + 1]; ++b) {
        row.row.push_back({table_.indices[at(old.rows.firstIndex + b)], table_.weights[at(old.rows.firstWeight + b)]});
      }
      for (std::int32_t t = old.shareOffsets[at(r)]; t < old.shareOffsets[at(r) + 1]; ++t) {
        row.row.push_back({table_.sourceCount + old.faces[at(t)], table_.weights[at(old.firstShare + t)]});
      }
    }
    if (old.rowCount() > 0) {
      table_.indices.edit().resize(at(old.rows.firstIndex));
      table_.weights.resize(at(old.rows.firstWeight));
    }
    return kept;
  }

  /// New sums are large faces without outputs, whose first two weights are read by none.
  void addSums() {
    for (const PointSum& sum : changes_.sums) {
      table_.projected.push_back({static_cast<std::int32_t>(sum.points.size()), 0, 0,
                                  static_cast<std::int32_t>(table_.indices.size()), 0,
                                  static_cast<std::int32_t>(table_.weights.size())});
      table_.indices.edit().append(sum.points.begin(), sum.points.end());
      table_.weights.resize(table_.weights.size() + 2, 0.0);
      table_.weights.append(sum.weights.begin(), sum.weights.end());
    }
  }

  void addRows(const std::vector<ReplacedRow>& keptSummed) {
    SummedRowWriter summed(table_);
    for (const ReplacedRow& row : keptSummed) summed.add(row);
    for (const ReplacedRow& row : changes_.rows) {
      if (std::ranges::any_of(row.row, [&](const Weight& entry) { return entry.point >= table_.sourceCount; })) {
        summed.add(row);
      } else {
        addLoose(row);
      }
    }
    summed.finish();
    table_.loose.firstIndex = static_cast<std::int32_t>(table_.indices.size());
    table_.loose.firstWeight = static_cast<std::int32_t>(table_.weights.size());
    table_.indices.edit().append(looseIndices_.begin(), looseIndices_.end());
    table_.weights.append(looseWeights_.begin(), looseWeights_.end());
  }

  void addLoose(const ReplacedRow& row) {
    for (const Weight& entry : row.row) {
      looseIndices_.push_back(entry.point);
      looseWeights_.push_back(entry.weight);
    }
    closeLoose(row.output);
  }

  /// Drops large faces that neither write nor are read.
  void dropUnread() {
    std::vector<std::int32_t> numbers(table_.projected.size(), 0);
    for (const std::int32_t face : table_.summed.faces) numbers[at(face)] = 1;
    std::int32_t kept = 0;
    for (std::size_t f = 0; f < numbers.size(); ++f) {
      if (numbers[f] == 0 && table_.projected[f].outputs == 0) continue;
      numbers[f] = kept;
      table_.projected[at(kept++)] = table_.projected[f];
    }
    table_.projected.resize(at(kept));
    for (std::int32_t& face : table_.summed.faces) face = numbers[at(face)];
  }

  LevelTable& table_;
  const RowChanges& changes_;
  std::vector<std::uint8_t> goes_;  // per output
  std::vector<std::int32_t> looseIndices_;
  std::vector<double> looseWeights_;
};

}  // namespace

void replaceRows(LevelTable& table, const RowChanges& changes) {
  if (!changes.rows.empty()) Replacement(table, changes).apply();
}

}  // namespace honeycomb::Far
