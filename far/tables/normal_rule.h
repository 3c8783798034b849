#pragma once

#include <cstdint>
#include <vector>

#include "far/tables/limit_table.h"
#include "far/tables/refinement.h"

namespace honeycomb::Far {

/// A vertex with more faces tells nothing of the direction of one point beside it, and costs as much for each of them.
constexpr std::size_t kMostFacesOfVertex = 64;
/// A point sums at most so many normals: what a tile can hold with the corners of their faces.
constexpr std::size_t kMostSummedNormals = 256;

/// Where the fast normals of a level's vertices come from: a face keeps its limit normal T1 x T2 through all levels, so
/// that it is found once, from the points of the level where the face is born, and a vertex of level L takes the
/// direction of the sum of some normals of faces of level L - 1:
///     corner point of a whole face f      f twice, and the face across the half-edge it lies beside (zip), or those
///                                         across the two half-edges at its corner; f once more for each that is
///                                         missing
///     other points                        of each face round the vertex what it was made from: a face; the two faces
///                                         of an edge; the faces of a vertex, unless they are more than
///                                         kMostFacesOfVertex. Of more than kMostSummedNormals every second, third ..
/// Against the exact normal of a vertex (its child face's) on a rough mesh: 0.4 degrees mean at level 4, 1.2 at
/// level 3. Points that are not vertices (central control vertices) have the zero vector.
class NormalRule {
 public:
  /// Level L, 1 .. levelCount.
  NormalRule(const Refinement& refinement, std::int32_t level);

  /// Normals have the numbers firstNormal(k) + f of the face f and the level k where it is born; not all numbers are
  /// taken.
  std::int32_t normalCount() const { return firstNormals_.back(); }
  /// The number of the normal of face 0 of level k.
  std::int32_t firstNormal(std::int32_t k) const { return firstNormals_[static_cast<std::size_t>(k)]; }
  /// Of a face of level L - 1.
  std::int32_t normalOf(std::int32_t face) const { return normals_[static_cast<std::size_t>(face)]; }

  /// The rows of the normals that are born at level k < L, from its points; element: number of the normal.
  LimitRows frames(std::int32_t k) const;

  std::int32_t pointCount() const { return level_.pointCount(); }
  /// Normals a corner point takes beside its face's own.
  std::int32_t cornerNeighbours() const { return level_.cornerPlace == CornerPlace::corner ? 2 : 1; }
  /// Calls visit(number of a normal) for those a point sums, in this order.
  template <class Visit>
  void visit(std::int32_t point, const Visit& visit) const {
    if (point < level_.cornerPoints) {
      visitCorner(point, visit);
    } else {
      for (const std::int32_t normal : around(point)) visit(normal);
    }
  }

 private:
  template <class Visit>
  void visitCorner(std::int32_t point, const Visit& visit) const;
  std::vector<std::int32_t> around(std::int32_t vertex) const;
  void appendAt(std::int32_t vertex, std::vector<std::int32_t>& normals) const;
  std::vector<std::uint8_t> bornRuns(std::int32_t k) const;
  void trace();

  const Refinement& refinement_;
  std::int32_t last_;
  const Level& level_;
  const Topology& before_;
  std::vector<std::int32_t> firstNormals_;       // per level 0 .. L-1, and the end
  std::vector<std::int32_t> normals_;            // per face of level L - 1
  std::vector<std::vector<std::uint8_t>> born_;  // per level, per run: are its faces born there?
};

template <class Visit>
void NormalRule::visitCorner(std::int32_t point, const Visit& visit) const {
  // A corner point has the number of the half-edge that leaves it in its whole face-face.
  const std::int32_t child = level_.topology.face(point);
  const std::int32_t face = level_.topology.parents()[static_cast<std::size_t>(child)];
  const auto offset = [](const Topology& of, std::int32_t f) { return of.faceOffsets()[static_cast<std::size_t>(f)]; };
  const std::int32_t h = offset(before_, face) + point - offset(level_.topology, child);
  const std::int32_t own = normalOf(face);
  const auto across = [&](std::int32_t halfEdge) {
    const std::int32_t twin = before_.twin(halfEdge);
    return twin < 0 ? own : normalOf(before_.face(twin));
  };
  visit(own);
  visit(own);
  visit(across(h));
  if (level_.cornerPlace == CornerPlace::corner) visit(across(before_.prev(h)));
}

/// Fast normals of one level as arrays: what NormalRule says. Normals are unit vectors, by the operations of LimitRows
/// for faces, and for vertices n = ((n_a + n_b) + n_c) + ... made unit the same way.
struct NormalTable {
  std::int32_t level = 0;
  std::int32_t faceNormals = 0;       ///< numbers of face normals
  std::vector<LimitRows> frames;      ///< per level 0 .. level - 1
  std::vector<std::int32_t> offsets;  ///< per point of the level (+1), into
  std::vector<std::int32_t> faces;    ///< numbers of face normals
  std::int64_t byteCount() const;
};

/// Errors: invalidOption for a level that the refinement doesn't have.
Result<NormalTable> buildNormalTable(const Refinement& refinement, std::int32_t level);

}  // namespace honeycomb::Far
