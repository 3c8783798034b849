#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <mutex>
#include <span>
#include <tuple>
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
  /// May its row read sums?
  bool readsSums(std::int32_t point) const;
  /// Is point `point` made of corners of a face of the level before, and its central control vertex, alone?
  bool liesIn(std::int32_t point, std::int32_t face) const;
  /// Round which vertices a point's stencil may reach into other faces from a cell's chart, by the half-edges of that
  /// face that leave them; `further` are more of them.
  struct Pivots {
    std::vector<std::int32_t> corners;
    const Charts::Round* further = nullptr;
    bool beyond = false;  ///< other parts of the face may be seen, over the cuts that close
  };
  Pivots pivotsOf(std::int32_t point, const ChartCell& cell) const;
  /// Of a face that grew together from parts the first stands for all; another part may have to be crossed for it.
  Charts::Place findFace(std::int32_t face, const Pivots& pivots) const;
  /// Point `point` in the chart of a cell, point by point of its stencil. Entries from sourceCount on are sums, as
  /// ReplacedRow has them.
  Row rowIn(std::int32_t point, const ChartCell& cell) const;
  /// What can't be continued takes the chart's value at the pivot that weighs most in the stencil.
  Row clampedRow(std::int32_t point, std::int32_t chart, const Pivots& pivots) const;

 private:
  /// The row of a point, with the sums of whole faces apart.
  template <class Take, class TakeSum>
  void visitFaces(std::int32_t point, const Take& take, const TakeSum& takeSum) const {
    rows_.visitApart(point, take, [&](const LevelRows::Sum& sum, double share) {
      if (!sums_.parts(sum).empty()) return takeSum(sum, share);
      rows_.visitSum(sum, [&](std::int32_t p, double w) { take(p, share * w); });
    });
  }

  /// A sum of many parts in a chart.
  struct Seen {
    bool plain = true;       // in one chart with it
    bool continued = false;  // `row` has it
    Charts::ChartRow row;
  };

  std::int32_t centralFace(std::int32_t point) const;
  std::vector<std::int32_t> cornersBeyond(std::int32_t chart) const;
  const Charts::Round& beyond(std::int32_t chart) const;
  const Charts::Round& justBeyond(std::int32_t chart) const;
  const Charts::Round& around(std::int32_t p) const;
  Charts::Place findVertex(std::int32_t p, const Pivots& pivots) const;
  const Seen& seen(const LevelRows::Sum& sum, std::int32_t chart) const;
  Seen see(const LevelRows::Sum& sum, std::int32_t chart, const Charts::Round& round) const;
  std::int32_t heaviest(std::int32_t point, const Pivots& pivots) const;
  bool addSource(std::int32_t p, double weight, std::int32_t chart, const Pivots& pivots, Charts::ChartRow& row) const;
  bool addSum(const LevelRows::Sum& sum, double share, std::int32_t chart, const Pivots& pivots,
              Charts::ChartRow& row) const;
  bool addManyParts(const LevelRows::Sum& sum, double share, std::int32_t chart, const Pivots& pivots,
                    Charts::ChartRow& row) const;
  bool addCentral(std::int32_t f, double weight, std::int32_t chart, const Pivots& pivots, Charts::ChartRow& row) const;
  Charts::Place placeOf(std::int32_t face, std::int32_t chart, const Pivots& pivots) const;

  const Charts& charts_;
  const Topology& old_;
  LevelRows rows_;
  ChartSums sums_;
  std::vector<std::int32_t> faceOfInput_;
  std::int32_t sourceCount_;
  mutable std::mutex lock_;                               // of what is found when it is asked for, by whichever thread
  mutable std::map<std::int32_t, Charts::Round> beyond_;  // by face
  mutable std::map<std::int32_t, Charts::Round> justBeyond_;                           // by face
  mutable std::map<std::int32_t, Charts::Round> around_;                               // by vertex
  mutable std::map<std::tuple<std::int32_t, std::int32_t, std::int32_t>, Seen> seen_;  // by face, projection, chart
};

}  // namespace honeycomb::Far
