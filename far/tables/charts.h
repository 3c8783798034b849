#pragma once

#include <array>
#include <complex>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "far/schemes/source_level.h"
#include "far/topology/crease_cut.h"
#include "far/topology/topology.h"

namespace honeycomb::Far {

/// The face-varying values of one level: each corner of a face has a value; along an edge whose ends have the same
/// values on both sides the charts of the two faces are one, along a seam they aren't.
///
/// A chart is continued across a seam by the similarity of the plane (rotation, uniform scale, translation) that takes
/// the edge's two values in the chart beyond to those in the chart itself; so texture coordinates (length 2) go on
/// beyond their seam at their own density. Other values, and charts without area, aren't continued.
class Charts {
 public:
  /// `corners`: a value for each half-edge, the corner it leaves in its face. `values`: `length` numbers a value; where
  /// no edge of level 0 is a seam (`mayHaveSeams`) nothing looks at them. `firstCentral`: the value of face 0's central
  /// control vertex, -1 when faces have none.
  Charts(const Topology& topology, std::span<const std::int32_t> corners, std::span<const double> values,
         std::int32_t length, std::int32_t firstCentral, bool mayHaveSeams);

  bool hasSeams() const { return seams_; }
  /// Does a seam meet a corner of face f?
  bool touched(std::int32_t f) const { return seams_ && touched_[static_cast<std::size_t>(f)] != 0; }
  bool isSeam(std::int32_t h) const;
  const Topology& topology() const { return topology_; }
  /// Are values continued at all?
  bool planar() const { return length_ == 2; }
  std::int32_t corner(std::int32_t h) const { return corners_[static_cast<std::size_t>(h)]; }

  /// The half-edge at which vertex v is a corner of face f, -1 if it is none. Linear in the smaller of valence and
  /// sides.
  std::int32_t cornerOf(std::int32_t v, std::int32_t f) const;

  /// A face whose values are to be read in a chart.
  struct Place {
    std::int32_t face = -1;                             ///< -1: it was not found
    std::int32_t corner = -1;                           ///< the half-edge of the corner looked for
    std::int32_t walked = 0;                            ///< edges that were crossed to find it, on all ways
    bool plain = true;                                  ///< no seam lies between
    bool continued = false;                             ///< `toChart` is meaningful
    std::array<std::complex<double>, 2> toChart{1, 0};  ///< factor and shift of the similarity
  };
  /// Where a walk round a vertex is, or ended.
  struct Walk {
    std::int32_t pivot = -1;  ///< the half-edge it began with
    std::int32_t order = 0;   ///< of walks as good as each other the first counts
    std::int32_t h = -1;      ///< the half-edge that leaves the vertex in the face it has come to; -1: it is over
    std::int32_t seams = 0;
    std::int32_t steps = 0;
    Place place;
    bool counterClockwise() const { return order % 2 == 0; }
    bool betterThan(const Walk& other) const;
  };
  /// All faces round some corners of a face, ascending, and the best way to each.
  struct Round {
    std::vector<std::int32_t> pivots;  ///< the corners, ascending half-edges
    std::vector<Walk> ways;
    /// nullptr: the face isn't among them.
    const Walk* to(std::int32_t face) const;
  };
  /// Walks round the vertices that `pivots`, ascending half-edges of one face, leave, each way over at most so many
  /// edges. Linear in these, at most in the valences, and a logarithm.
  Round walkRound(std::span<const std::int32_t> pivots,
                  std::int32_t most = std::numeric_limits<std::int32_t>::max()) const;
  /// Corners of a face, or vertices, of more than this many others are better looked for in a Round.
  static constexpr std::int32_t kFewFaces = 16;

  /// Face `face` seen from the chart of the face of `pivots`, half-edges of that face: round the vertices they leave,
  /// the way that crosses the fewest seams, then the fewest edges, then the first. Takes as many steps as the way has
  /// edges; where others may cross fewer seams, as far as these go. Round a vertex of many faces from its outgoing()
  /// logarithmic: those walks are remembered. `further`: round more corners of the face, which come last.
  Place findFace(std::int32_t face, std::span<const std::int32_t> pivots, const Round* further = nullptr) const;
  /// The face of the corners that `round` was walked from, seen from the chart of the face of `pivots`, where it isn't
  /// met round these: over a face that both meet, or the chart's own, by the way that is best as a whole. Linear in the
  /// valences at the pivots, and a logarithm each.
  Walk findOver(std::span<const std::int32_t> pivots, const Round& round) const;
  /// The nearest face that has vertex v, in the same way; where a walk is remembered, linear in v's valence too, if
  /// that is small.
  Place findVertex(std::int32_t v, std::span<const std::int32_t> pivots, const Round* further = nullptr) const;

  /// A stencil row in the chart of a face. What is continued is summed up as a point of the chart's plane, and written
  /// as weights on three of the face's own corners, so that rows stay rows.
  struct ChartRow {
    Row row;
    double weight = 0;
    std::complex<double> sum = 0;
  };
  /// Adds weight times a corner seen from a chart; false when it can't be continued.
  bool add(const Place& place, double weight, ChartRow& row) const;
  /// Adds `share` times a sum of values of the chart of `place`, which isn't plain, with their weights summed up too;
  /// false when it can't be continued.
  bool add(const Place& place, std::complex<double> sum, double weight, double share, ChartRow& row) const;
  /// Writes what was summed up as weights on the corners of `face`; false when that can't be done.
  bool close(std::int32_t face, ChartRow& row) const;

  /// The central control vertex of face f, where faces have one.
  std::int32_t central(std::int32_t f) const { return firstCentral_ + f; }
  bool hasCentral() const { return firstCentral_ >= 0; }
  std::complex<double> value(std::int32_t i) const {
    return {values_[2 * static_cast<std::size_t>(i)], values_[2 * static_cast<std::size_t>(i) + 1]};
  }

 private:
  bool step(Walk& walk) const;
  template <class Remembered, class Found>
  Walk search(std::span<const std::int32_t> pivots, const Round* further, const Remembered& remembered,
              const Found& found) const;
  const Round* roundFrom(std::int32_t pivot) const;
  void findRounds();
  void cross(std::int32_t h, Place& place) const;
  std::int32_t across(std::int32_t h) const;
  bool equal(std::int32_t a, std::int32_t b) const;
  void findSeams();
  void findFrames();
  std::array<std::int32_t, 3> frameOf(std::int32_t f) const;

  const Topology& topology_;
  std::span<const std::int32_t> corners_;
  std::span<const double> values_;
  std::int32_t length_;
  std::int32_t firstCentral_;
  CreaseSides creases_;
  double tolerance_ = 0;
  bool seams_ = false;
  std::vector<std::uint8_t> touched_;                // per face
  std::vector<std::array<std::int32_t, 3>> frames_;  // per face: half-edges of three corners that span the plane, or -1
  std::vector<Round> rounds_;                        // of the vertices of many faces on seams, ascending
};

}  // namespace honeycomb::Far
