#pragma once

#include <array>
#include <cassert>
#include <compare>
#include <cstdint>
#include <vector>

#include "far/base/index.h"
#include "far/tables/level_table.h"

namespace honeycomb::Far {

/// The rows of a level table one by one, whatever batch they are in: for those who compose tables, write them down or
/// hand them to others. Four bytes an output point; reads the table, which must outlive it.
class LevelRows {
 public:
  enum class Kind : std::uint8_t { circulant, projected, dense, summed, loose };
  /// Where the row of an output point stands.
  struct Place {
    Kind kind = Kind::loose;
    std::int32_t batch = 0;  ///< in the table's batches of that kind; 0 for summed and loose rows
    std::int32_t item = 0;   ///< face of a circulant batch, row of dense, summed or loose rows; 0 for a projected face
    std::int32_t row = 0;    ///< output of that face; 0 for all rows
    /// Outputs of one face read the same points.
    bool sameFace(const Place& other) const { return kind == other.kind && batch == other.batch && item == other.item; }
  };

  /// Linear in the output points, in parallel.
  explicit LevelRows(const LevelTable& table);

  const LevelTable& table() const { return *table_; }
  std::int32_t rowCount() const { return table_->targetCount; }
  Place place(std::int32_t output) const;

  /// Entries that visit() hands out; a point may come more than once.
  std::int32_t entryCount(std::int32_t output) const;

  /// Calls take(source point, weight) for every entry of the row, in the order in which the batch's points stand.
  /// The sum of weight times point over the entries is the output point, up to rounding.
  template <class Take>
  void visit(std::int32_t output, const Take& take) const {
    const Place p = place(output);
    switch (p.kind) {
      case Kind::circulant:
        return visitCirculant(table_->circulants[at(p.batch)], p, take);
      case Kind::projected:
        return visitProjected(table_->projected[at(p.batch)], p.row, take);
      case Kind::dense:
        return visitDense(table_->dense[at(p.batch)], p.item, take);
      case Kind::summed:
        return visitSummed(p.item, take);
      case Kind::loose:
        return visitEntries(table_->loose, p.item, take);
    }
  }

  /// The same for the entries of a summed row alone, without what its shares of large faces stand for.
  template <class Take>
  void visitOwnEntries(std::int32_t summedRow, const Take& take) const {
    visitEntries(table_->summed.rows, summedRow, take);
  }

  /// One of the sums over the corners of a large face, which many rows read.
  struct Sum {
    std::int32_t face = 0;        ///< in the table's projected faces
    std::int32_t projection = 0;  ///< 0: S, 1: C, 2: D (see ProjectedFace); 0 where the face has no outputs
    auto operator<=>(const Sum&) const = default;
  };

  /// The same as visit(), but what a row reads of all corners of a large face goes to takeSum(Sum, weight): a few calls
  /// a row, however large the face.
  template <class Take, class TakeSum>
  void visitApart(std::int32_t output, const Take& take, const TakeSum& takeSum) const {
    const Place p = place(output);
    if (p.kind == Kind::projected) return visitProjectedApart(p, take, takeSum);
    if (p.kind != Kind::summed) return visit(output, take);
    visitOwnEntries(p.item, take);
    visitShares(p.item, [&](std::int32_t face, double share) { takeSum(Sum{face, 0}, share); });
  }

  /// Calls take(source point, weight) for the corners that a sum is made of.
  template <class Take>
  void visitSum(const Sum& sum, const Take& take) const {
    visitSum(*table_, sum, take);
  }
  template <class Take>
  static void visitSum(const LevelTable& table, const Sum& sum, const Take& take) {
    const ProjectedFace& face = table.projected[at(sum.face)];
    const std::int64_t s = face.firstWeight + 2 + std::int64_t{sum.projection} * face.corners;
    for (std::int32_t j = 0; j < face.corners; ++j)
      take(table.indices[at(face.firstIndex + j)], table.weights[at(s + j)]);
  }

  /// Calls take(large face, weight) for the shares of a summed row.
  template <class Take>
  void visitShares(std::int32_t summedRow, const Take& take) const {
    const SummedRows& rows = table_->summed;
    for (std::int32_t t = rows.shareOffsets[at(summedRow)]; t < rows.shareOffsets[at(summedRow) + 1]; ++t) {
      take(rows.faces[at(t)], weight(rows.firstShare + t));
    }
  }

 private:
  double weight(std::int64_t i) const { return table_->weights[at(i)]; }
  std::int32_t source(std::int64_t i) const { return table_->indices[at(i)]; }

  template <class Take>
  void visitCirculant(const CirculantBatch& batch, const Place& p, const Take& take) const {
    const std::int64_t first = batch.firstIndex + std::int64_t{p.item} * batch.sides;
    std::int32_t corner = p.row;
    for (std::int32_t k = 0; k < batch.sides; ++k) {
      take(source(first + corner), weight(batch.firstRow + k));
      if (++corner == batch.sides) corner = 0;
    }
  }

  template <class Take>
  void visitProjected(const ProjectedFace& face, std::int32_t i, const Take& take) const {
    const std::int64_t s = std::int64_t{face.firstWeight} + 2;
    const std::int64_t n = face.corners;
    const std::int64_t x = s + 3 * n + i;
    const std::array<std::int32_t, 2> near = nearCorners(face, i);
    for (std::int32_t j = 0; j < face.corners; ++j) {
      double w = weight(x) * weight(s + j) + weight(x + face.outputs) * weight(s + n + j) +
                 weight(x + 2 * std::int64_t{face.outputs}) * weight(s + 2 * n + j);
      if (j == near[0]) w += weight(face.firstWeight);
      if (j == near[1]) w += weight(face.firstWeight + 1);
      take(source(face.firstIndex + j), w);
    }
  }

  template <class Take, class TakeSum>
  void visitProjectedApart(const Place& p, const Take& take, const TakeSum& takeSum) const {
    const ProjectedFace& face = table_->projected[at(p.batch)];
    const std::array<std::int32_t, 2> near = nearCorners(face, p.row);
    take(source(face.firstIndex + near[0]), weight(face.firstWeight));
    take(source(face.firstIndex + near[1]), weight(face.firstWeight + 1));
    const std::int64_t x = face.firstWeight + 2 + 3 * std::int64_t{face.corners} + p.row;
    for (std::int32_t projection = 0; projection < 3; ++projection) {
      const double share = weight(x + std::int64_t{projection} * face.outputs);
      if (share != 0) takeSum(Sum{p.batch, projection}, share);
    }
  }

  /// The two corners that output i of a large face reads beside its sums.
  static std::array<std::int32_t, 2> nearCorners(const ProjectedFace& face, std::int32_t i) {
    const std::int32_t from = face.firstCorner + i;
    const std::int32_t a = from < face.corners ? from : from - face.corners;
    return {a, a + 1 == face.corners ? 0 : a + 1};
  }

  template <class Take>
  void visitDense(const DenseRows& batch, std::int32_t item, const Take& take) const {
    const std::int64_t first = batch.firstIndex + std::int64_t{item} * batch.width;
    for (std::int32_t j = 0; j < batch.width; ++j) take(source(first + j), weight(batch.firstWeight + j));
  }

  template <class Take>
  void visitSummed(std::int32_t item, const Take& take) const {
    visitOwnEntries(item, take);
    visitShares(item, [&](std::int32_t face, double share) {
      visitSum({face, 0}, [&](std::int32_t point, double w) { take(point, share * w); });
    });
  }

  template <class Take>
  void visitEntries(const LooseRows& rows, std::int32_t item, const Take& take) const {
    for (std::int32_t b = rows.offsets[at(item)]; b < rows.offsets[at(item) + 1]; ++b) {
      take(source(rows.firstIndex + b), weight(rows.firstWeight + b));
    }
  }

  /// Contiguous outputs of one batch.
  struct Range {
    Kind kind;
    std::int32_t batch;
    std::int32_t firstOutput;
    std::int32_t itemOutputs;  // outputs of one item
  };
  void addRange(const Range& range, std::int64_t outputs);

  const LevelTable* table_;
  std::vector<Range> ranges_;
  std::vector<std::int32_t> places_;  // by output point: a range, or -1 - row: loose ones, then summed ones
};

}  // namespace honeycomb::Far
