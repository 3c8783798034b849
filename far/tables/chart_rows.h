#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "far/base/index.h"
#include "far/tables/chart_sums.h"
#include "far/tables/charts.h"
#include "far/tables/level_rows.h"
#include "far/topology/topology.h"

namespace honeycomb::Far {

/// A face of the child: the parent face in whose chart its corners are, and the parent's vertices round which other
/// faces are looked for, by the half-edges that leave them in that face.
struct ChartCell {
  std::int32_t chart = 0;
  FaceParent made = FaceParent::face;
  std::array<std::int32_t, 2> pivots{-1, -1};
  std::size_t pivotCount = 0;
  std::span<const std::int32_t> known() const { return std::span(pivots).first(pivotCount); }
};

/// The rows of a level's points read in the charts of faces of the level before: see FaceVarying.
class ChartRows {
 public:
  /// `table`: of the level, whose rows are read; `faceOfInput`: faces by the caller's numbers, where central control
  /// points are in that order, else empty; `sourceCount`: values of the level before. All must outlive it.
  ChartRows(const LevelTable& table, const Charts& charts, std::vector<std::int32_t> faceOfInput,
            std::int32_t sourceCount)
      : charts_(charts),
        old_(charts.topology()),
        rows_(table),
        sums_(rows_, charts),
        faceOfInput_(std::move(faceOfInput)),
        sourceCount_(sourceCount) {}
  ChartRows(const ChartRows&) = delete;
  ChartRows& operator=(const ChartRows&) = delete;

  const LevelRows& rows() const { return rows_; }
  /// The sums that rows may read, to be named first.
  ChartSums& sums() { return sums_; }

  /// Does a point come from a batch of faces?
  bool hasFaceRow(std::int32_t point) const;
  /// Is point `point` made of corners of a face of the level before, and its central control vertex, alone?
  bool liesIn(std::int32_t point, std::int32_t face) const;
  /// The half-edges in the cell's chart round whose vertices a point's stencil may reach into other faces.
  std::vector<std::int32_t> pivotsOf(std::int32_t point, const ChartCell& cell) const;
  /// Point `point` in the chart of a cell, point by point of its stencil. Entries from sourceCount on are sums, as
  /// ReplacedRow has them.
  Row rowIn(std::int32_t point, const ChartCell& cell) const;
  /// What can't be continued takes the chart's value at the pivot that weighs most in the stencil.
  Row clampedRow(std::int32_t point, std::int32_t chart, std::span<const std::int32_t> pivots) const;

 private:
  /// The row of a point, with the sums of whole faces apart.
  template <class Take, class TakeSum>
  void visitFaces(std::int32_t point, const Take& take, const TakeSum& takeSum) const {
    rows_.visitApart(point, take, [&](const LevelRows::Sum& sum, double share) {
      if (sums_.of(sum).face >= 0) return takeSum(sum, share);
      rows_.visitSum(sum, [&](std::int32_t p, double w) { take(p, share * w); });
    });
  }

  std::int32_t centralFace(std::int32_t point) const;
  bool addSource(std::int32_t p, double weight, std::int32_t chart, std::span<const std::int32_t> pivots,
                 Charts::ChartRow& row) const;
  bool addSum(const LevelRows::Sum& sum, double share, std::int32_t chart, std::span<const std::int32_t> pivots,
              Charts::ChartRow& row) const;
  bool addCentral(std::int32_t f, double weight, std::int32_t chart, std::span<const std::int32_t> pivots,
                  Charts::ChartRow& row) const;

  const Charts& charts_;
  const Topology& old_;
  LevelRows rows_;
  ChartSums sums_;
  std::vector<std::int32_t> faceOfInput_;
  std::int32_t sourceCount_;
};

}  // namespace honeycomb::Far
