#include "far/tables/replaced_rows.h"

#include <utility>

#include "far/base/index.h"

namespace honeycomb::Far {

namespace {

class Replacement {
 public:
  Replacement(LevelTable& table, const std::vector<ReplacedRow>& rows)
      : table_(table), rows_(rows), goes_(at(table.targetCount), 0) {
    for (const ReplacedRow& row : rows) goes_[at(row.output)] = 1;
  }

  void apply() {
    cutCirculants();
    cutDense();
    cutProjected();
    cutSummed();
    rewriteLoose();
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

  /// Summed rows go on reading the sums of faces whose outputs are replaced: such a face stays, without outputs.
  void cutProjected() {
    const bool read = table_.summed.rowCount() > 0;
    for (ProjectedFace& face : table_.projected) {
      if (face.outputs > 0 && goes_[at(face.firstOutput)] != 0) face.outputs = 0;
    }
    if (!read) std::erase_if(table_.projected, [](const ProjectedFace& face) { return face.outputs == 0; });
  }

  /// The rows that stay move together; what they leave of the table's arrays behind them is read by none.
  void cutSummed() {
    const SummedRows old = std::exchange(table_.summed, {});
    SummedRows& kept = table_.summed;
    Array<std::int32_t>& indices = table_.indices.edit();
    kept.rows.firstIndex = old.rows.firstIndex;
    kept.rows.firstWeight = old.rows.firstWeight;
    kept.firstShare = old.firstShare;
    std::int32_t entries = 0;
    for (std::int32_t r = 0; r < old.rowCount(); ++r) {
      if (goes_[at(old.rows.outputs[at(r)])] != 0) continue;
      for (std::int32_t b = old.rows.offsets[at(r)]; b < old.rows.offsets[at(r) + 1]; ++b, ++entries) {
        indices[at(old.rows.firstIndex + entries)] = indices[at(old.rows.firstIndex + b)];
        table_.weights[at(old.rows.firstWeight + entries)] = table_.weights[at(old.rows.firstWeight + b)];
      }
      for (std::int32_t t = old.shareOffsets[at(r)]; t < old.shareOffsets[at(r) + 1]; ++t) {
        table_.weights[at(old.firstShare) + kept.faces.size()] = table_.weights[at(old.firstShare + t)];
        kept.faces.push_back(old.faces[at(t)]);
      }
      kept.rows.outputs.push_back(old.rows.outputs[at(r)]);
      kept.rows.offsets.push_back(entries);
      kept.shareOffsets.push_back(static_cast<std::int32_t>(kept.faces.size()));
    }
  }

  /// The loose rows are the last of the table's indices and weights.
  void rewriteLoose() {
    LooseRows loose;
    std::vector<std::int32_t> indices;
    std::vector<double> weights;
    const LooseRows& old = table_.loose;
    const auto close = [&](std::int32_t output) {
      loose.outputs.push_back(output);
      loose.offsets.push_back(static_cast<std::int32_t>(indices.size()));
    };
    for (std::int32_t r = 0; r < old.rowCount(); ++r) {
      if (goes_[at(old.outputs[at(r)])] != 0) continue;
      for (std::int32_t b = old.offsets[at(r)]; b < old.offsets[at(r) + 1]; ++b) {
        indices.push_back(table_.indices[at(old.firstIndex + b)]);
        weights.push_back(table_.weights[at(old.firstWeight + b)]);
      }
      close(old.outputs[at(r)]);
    }
    for (const ReplacedRow& row : rows_) {
      for (const Weight& entry : row.row) {
        indices.push_back(entry.point);
        weights.push_back(entry.weight);
      }
      close(row.output);
    }
    loose.firstIndex = old.firstIndex;
    loose.firstWeight = old.firstWeight;
    table_.indices.edit().resize(at(old.firstIndex));
    table_.weights.resize(at(old.firstWeight));
    table_.indices.edit().append(indices.begin(), indices.end());
    table_.weights.append(weights.begin(), weights.end());
    table_.loose = std::move(loose);
  }

  LevelTable& table_;
  const std::vector<ReplacedRow>& rows_;
  std::vector<std::uint8_t> goes_;  // per output
};

}  // namespace

void replaceRows(LevelTable& table, const std::vector<ReplacedRow>& rows) {
  if (!rows.empty()) Replacement(table, rows).apply();
}

}  // namespace honeycomb::Far
