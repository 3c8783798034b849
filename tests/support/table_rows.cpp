#include "tests/support/table_rows.h"

namespace honeycomb::Test {
namespace {

class Expansion {
 public:
  explicit Expansion(const Far::LevelTable& table)
      : table_(table), rows_(static_cast<std::size_t>(table.targetCount)), written_(rows_.size(), 0) {}

  std::vector<StencilRow> run() {
    for (const Far::CirculantBatch& batch : table_.circulants) circulant(batch);
    for (const Far::ProjectedFace& face : table_.projected) projected(face);
    for (const Far::DenseRows& batch : table_.dense) dense(batch);
    summed();
    loose();
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      if (written_[r] != 1) rows_[r].clear();
    }
    return std::move(rows_);
  }

 private:
  double weight(std::int32_t i) const { return at(table_.weights, i); }
  std::int32_t source(std::int32_t i) const { return at(table_.indices, i); }
  StencilRow& open(std::int32_t output) {
    ++at(written_, output);
    return at(rows_, output);
  }

  void circulant(const Far::CirculantBatch& b) {
    for (std::int32_t g = 0; g < b.faceCount; ++g) {
      for (std::int32_t i = 0; i < b.sides; ++i) {
        StencilRow& row = open(b.firstOutput + g * b.sides + i);
        for (std::int32_t k = 0; k < b.sides; ++k) {
          row[source(b.firstIndex + g * b.sides + (i + k) % b.sides)] += weight(b.firstRow + k);
        }
      }
    }
  }

  void projected(const Far::ProjectedFace& f) {
    const std::int32_t s = f.firstWeight + 2;
    const std::int32_t x = s + 3 * f.corners;
    for (std::int32_t i = 0; i < f.outputs; ++i) {
      StencilRow& row = open(f.firstOutput + i);
      const std::int32_t a = (f.firstCorner + i) % f.corners;
      row[source(f.firstIndex + a)] += weight(f.firstWeight);
      row[source(f.firstIndex + (a + 1) % f.corners)] += weight(f.firstWeight + 1);
      for (std::int32_t j = 0; j < f.corners; ++j) {
        double w = 0;
        for (std::int32_t part = 0; part < 3; ++part) {
          w += weight(x + part * f.outputs + i) * weight(s + part * f.corners + j);
        }
        row[source(f.firstIndex + j)] += w;
      }
    }
  }

  void dense(const Far::DenseRows& b) {
    for (std::int32_t g = 0; g < b.rowCount; ++g) {
      StencilRow& row = open(b.firstOutput + g);
      for (std::int32_t j = 0; j < b.width; ++j) {
        row[source(b.firstIndex + g * b.width + j)] += weight(b.firstWeight + j);
      }
    }
  }

  void loose() {
    const Far::LooseRows& rows = table_.loose;
    for (std::int32_t r = 0; r < rows.rowCount(); ++r) {
      StencilRow& row = open(at(rows.outputs, r));
      for (std::int32_t b = at(rows.offsets, r); b < at(rows.offsets, r + 1); ++b) {
        row[source(rows.firstIndex + b)] += weight(rows.firstWeight + b);
      }
    }
  }

  void summed() {
    const Far::SummedRows& s = table_.summed;
    for (std::int32_t r = 0; r < s.rowCount(); ++r) {
      StencilRow& row = open(at(s.rows.outputs, r));
      for (std::int32_t b = at(s.rows.offsets, r); b < at(s.rows.offsets, r + 1); ++b) {
        row[source(s.rows.firstIndex + b)] += weight(s.rows.firstWeight + b);
      }
      for (std::int32_t t = at(s.shareOffsets, r); t < at(s.shareOffsets, r + 1); ++t) {
        const Far::ProjectedFace& f = at(table_.projected, at(s.faces, t));
        for (std::int32_t j = 0; j < f.corners; ++j) {
          row[source(f.firstIndex + j)] += weight(s.firstShare + t) * weight(f.firstWeight + 2 + j);
        }
      }
    }
  }

  const Far::LevelTable& table_;
  std::vector<StencilRow> rows_;
  std::vector<int> written_;
};

}  // namespace

std::vector<StencilRow> expandRows(const Far::LevelTable& table) {
  return Expansion(table).run();
}

std::vector<StencilRow> composeRows(const std::vector<StencilRow>& outer, const std::vector<StencilRow>& inner) {
  std::vector<StencilRow> result(outer.size());
  for (std::size_t r = 0; r < outer.size(); ++r) {
    for (const auto& [middle, w] : outer[r]) {
      for (const auto& [point, v] : at(inner, middle)) result[r][point] += w * v;
    }
  }
  return result;
}

std::vector<Vec3> applyRows(const std::vector<StencilRow>& rows, const std::vector<Vec3>& points) {
  std::vector<Vec3> result(rows.size());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (const auto& [point, w] : rows[r]) result[r] = result[r] + w * at(points, point);
  }
  return result;
}

}  // namespace honeycomb::Test
