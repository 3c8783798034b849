#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "far/topology/topology.h"

namespace honeycomb::Far {

/// One entry of a stencil.
struct Weight {
  std::int32_t point = 0;
  double weight = 0;
  bool operator==(const Weight&) const = default;
};
/// A stencil: its entries in the order in which they are added.
using Row = std::vector<Weight>;

/// Which points a level has beside its vertices.
enum class CentralPoints : std::uint8_t {
  none,
  byFace,       ///< [V vertices | F central control vertices], face f's at V + f
  byInputFace,  ///< the same for control points, in the caller's order of faces: V + inputFace(f)
};

/// The points that a level's stencils read: a topology, and whether its faces have central control vertices.
class SourceLevel {
 public:
  SourceLevel(const Topology& topology, CentralPoints central) : topology_(topology), central_(central) {}

  const Topology& topology() const { return topology_; }
  bool hasCentral() const { return central_ != CentralPoints::none; }
  std::int32_t pointCount() const { return topology_.vertexCount() + (hasCentral() ? topology_.faceCount() : 0); }
  /// The central control vertex of face f.
  std::int32_t central(std::int32_t f) const {
    return topology_.vertexCount() + (central_ == CentralPoints::byInputFace ? topology_.inputFace(f) : f);
  }

  /// The number under which rows read the sum of all vertices of large face f, or the first of its Scheme::faceSums, as
  /// a point behind all others; -1: of this face there is none. Numbers of sums count from pointCount().
  std::int32_t sumPoint(std::int32_t f) const {
    return sums_.empty() || sums_[static_cast<std::size_t>(f)] < 0 ? -1
                                                                   : pointCount() + sums_[static_cast<std::size_t>(f)];
  }
  /// `sums`: per face the number of its sum, -1 where it has none.
  void nameSums(std::vector<std::int32_t> sums) { sums_ = std::move(sums); }
  bool hasSums() const { return !sums_.empty(); }

  /// Appends weight times the barycentre of face f's vertices, by their sum where it has a name.
  void addBarycentre(std::int32_t f, double weight, Row& row) const;
  /// Appends weight times the central control vertex of face f; where the level has none, that is the barycentre.
  void addCentral(std::int32_t f, double weight, Row& row) const;

 private:
  const Topology& topology_;
  CentralPoints central_;
  std::vector<std::int32_t> sums_;
};

/// Adds up the entries of the same point, at the place of the first.
void mergeEntries(Row& row);

}  // namespace honeycomb::Far
