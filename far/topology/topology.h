#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "far/base/array.h"
#include "far/base/result.h"
#include "far/topology/polygons.h"

namespace honeycomb::Far {

/// How a face was cut by a boundary rule. The brick rule cuts faces in half by the boundary line, or to a corner of the
/// boundary. The clamped rule of half-box splines ends the surface in faces whose boundary vertices are Bezier points
/// of the boundary curve: sides, corners, and the triangles in the gaps between two of these.
enum class FaceKind : std::uint8_t {
  full,
  half,
  corner,
  clampedSide,    ///< loop L, R, q_1 .. q_m: the curve passes smoothly through the middle of L and R
  clampedCorner,  ///< loop L, J, R, q_1 .. q_m: the curve has a corner at J
  clampedGap      ///< loop R, L of the next face along the boundary, q_1 of this face and q_m of the next
};
constexpr std::size_t kFaceKinds = 6;
constexpr bool isCutByBrick(FaceKind kind) {
  return kind == FaceKind::half || kind == FaceKind::corner;
}
constexpr bool isClamped(FaceKind kind) {
  return kind != FaceKind::full && !isCutByBrick(kind);
}

/// What a face of a refined level was made from.
enum class FaceParent : std::uint8_t { face, vertex, edge };

/// Where a boundary vertex sits under the brick rule: a vertex of the mesh proper, the point where an edge crosses the
/// boundary line, a vertex tagged to become a corner, or a corner that stays where it is.
enum class VertexTag : std::uint8_t { interior, real, mid, corner, fixedCorner };

/// What a boundary half-edge is under the brick rule: an edge of the mesh on the boundary line, a cut through a face,
/// or the part of a cut between a fixed corner and the next vertex.
enum class EdgeTag : std::uint8_t { onLine, cut, cutToCorner };

/// A run of faces of one kind, parent and number of sides: contiguous in faces and in half-edges.
///     face       firstFace          firstFace+1         ...
///     half-edge  firstHalfEdge ..   firstHalfEdge+sides ..
struct FaceRun {
  FaceKind kind = FaceKind::full;
  FaceParent parent = FaceParent::face;
  std::int32_t sides = 0;
  std::int32_t firstFace = 0;
  std::int32_t firstHalfEdge = 0;
  std::int32_t faceCount = 0;
  bool operator==(const FaceRun&) const = default;
};

/// An edge along which a level is sharp. At level 0, where it is an edge like others, its two half-edges; refined
/// levels are cut open along their creases, and these are the half-edges on the two sides of the cut.
struct CreaseEdge {
  std::int32_t halfEdge = 0;  ///< the lower of the two
  std::int32_t mate = 0;
  double sharpness = 0;  ///< steps for which it stays sharp, from this level on; infinity: for all
  bool operator==(const CreaseEdge&) const = default;
};

/// The arrays of one level, as a split hands them over; Topology only reads them afterwards.
struct TopologyArrays {
  std::int32_t vertexCount = 0;
  bool threeValent = false;               ///< closed, and every vertex has three edges
  std::vector<FaceRun> runs;              ///< cover all faces in order; full faces first
  Array<std::int32_t> vert;               ///< per half-edge: the vertex it leaves
  Array<std::int32_t> twin;               ///< per half-edge: the opposite half-edge, -1 on a boundary
  Array<std::int32_t> face;               ///< per half-edge: its face
  Array<std::int32_t> faceOffsets;        ///< per face (+1): its first half-edge
  Array<std::int32_t> outgoing;           ///< per vertex: a half-edge leaving it; on a boundary the boundary one
  Array<std::int32_t> parents;            ///< per face: the face, vertex or edge (its lower half-edge) of the level
                                          ///< before that it was made from (the run says which); level 0: input face
  std::vector<std::int32_t> boundary;     ///< the boundary half-edges, ascending
  std::vector<EdgeTag> boundaryTags;      ///< one each
  std::vector<VertexTag> vertexTags;      ///< per vertex; empty when nothing is on a boundary
  std::vector<CreaseEdge> creases;        ///< ascending by half-edge, sharpness > 0
  std::vector<std::int32_t> heldCorners;  ///< with creases: the vertices that the caller tagged corners, ascending
};

/// The order of faces of one side count at level 0: the caller's, or one in which neighbours are near each other, so
/// that evaluation finds in the cache what it needs, also where the caller's order is random. The surface is the same,
/// its refined vertices and faces are numbered in another order.
enum class FaceOrder : std::uint8_t { input, spatial };

/// The connectivity of one level: half-edges stored as the concatenated loops of faces sorted into runs, so that a
/// half-edge's id is its place, and `next` and `prev` need no storage. Immutable.
///
/// Vertices keep the caller's numbers at level 0; faces are sorted stably by side count, inputFace() leads back,
/// whatever their order was before.
class Topology {
 public:
  Topology() = default;
  explicit Topology(TopologyArrays arrays) : a_(std::move(arrays)) {}

  /// Level 0 from polygons, fully validated. The error names the first defect and how many there are
  /// (findDefects lists them all); its element is the face, or the vertex of a bow-tie or isolated vertex.
  /// Linear in the number of corners, save a sort within the corners of each vertex.
  static Result<Topology> create(const Polygons& polygons, FaceOrder order = FaceOrder::input);

  std::int32_t vertexCount() const { return a_.vertexCount; }
  std::int32_t faceCount() const { return static_cast<std::int32_t>(a_.parents.size()); }
  std::int32_t halfEdgeCount() const { return static_cast<std::int32_t>(a_.vert.size()); }
  std::int32_t boundaryEdgeCount() const { return static_cast<std::int32_t>(a_.boundary.size()); }
  std::int32_t edgeCount() const { return (halfEdgeCount() + boundaryEdgeCount()) / 2; }
  /// V - E + F.
  std::int32_t eulerCharacteristic() const { return vertexCount() - edgeCount() + faceCount(); }
  bool closed() const { return a_.boundary.empty(); }
  /// Closed, and every vertex has three edges (known of refined levels; level 0 does not look).
  bool threeValent() const { return a_.threeValent; }

  std::span<const FaceRun> runs() const { return a_.runs; }
  std::span<const std::int32_t> vert() const { return a_.vert; }
  std::span<const std::int32_t> twin() const { return a_.twin; }
  std::span<const std::int32_t> face() const { return a_.face; }
  std::span<const std::int32_t> faceOffsets() const { return a_.faceOffsets; }
  std::span<const std::int32_t> outgoing() const { return a_.outgoing; }
  std::span<const std::int32_t> parents() const { return a_.parents; }
  std::span<const std::int32_t> boundary() const { return a_.boundary; }
  std::span<const EdgeTag> boundaryTags() const { return a_.boundaryTags; }

  std::int32_t vert(std::int32_t h) const { return a_.vert[index(h)]; }
  std::int32_t twin(std::int32_t h) const { return a_.twin[index(h)]; }
  std::int32_t face(std::int32_t h) const { return a_.face[index(h)]; }
  std::int32_t outgoing(std::int32_t v) const { return a_.outgoing[index(v)]; }
  std::int32_t sides(std::int32_t f) const { return a_.faceOffsets[index(f) + 1] - a_.faceOffsets[index(f)]; }
  std::int32_t next(std::int32_t h) const {
    const std::size_t f = index(face(h));
    return h + 1 == a_.faceOffsets[f + 1] ? a_.faceOffsets[f] : h + 1;
  }
  std::int32_t prev(std::int32_t h) const {
    const std::size_t f = index(face(h));
    return h == a_.faceOffsets[f] ? a_.faceOffsets[f + 1] - 1 : h - 1;
  }
  std::int32_t dest(std::int32_t h) const { return vert(next(h)); }
  /// Does h stand for its edge: the lower of its two half-edges, or the only one?
  bool leads(std::int32_t h) const { return twin(h) < 0 || h < twin(h); }
  /// The next outgoing half-edge counter-clockwise round vert(h); -1 past the last face of a boundary vertex.
  std::int32_t nextOutgoing(std::int32_t h) const { return twin(prev(h)); }

  std::span<const CreaseEdge> creases() const { return a_.creases; }
  std::span<const std::int32_t> heldCorners() const { return a_.heldCorners; }

  /// The half-edges of a face in the order of its loop, for a range-based loop.
  class FaceHalfEdges {
   public:
    struct Iterator {
      std::int32_t h;
      std::int32_t operator*() const { return h; }
      Iterator& operator++() {
        ++h;
        return *this;
      }
      bool operator!=(const Iterator& other) const { return h != other.h; }
    };
    FaceHalfEdges(std::int32_t first, std::int32_t end) : first_(first), end_(end) {}
    Iterator begin() const { return {first_}; }
    Iterator end() const { return {end_}; }

   private:
    std::int32_t first_, end_;
  };
  FaceHalfEdges halfEdgesOf(std::int32_t f) const { return {a_.faceOffsets[index(f)], a_.faceOffsets[index(f) + 1]}; }

  /// The half-edges that leave a vertex, counter-clockwise from outgoing(v), for a range-based loop.
  class OutgoingHalfEdges {
   public:
    struct Iterator {
      const Topology* topology;
      std::int32_t first, h;  // h is -1 at the end
      std::int32_t operator*() const { return h; }
      Iterator& operator++() {
        h = topology->nextOutgoing(h);
        if (h == first) h = -1;
        return *this;
      }
      bool operator!=(const Iterator& other) const { return h != other.h; }
    };
    OutgoingHalfEdges(const Topology& topology, std::int32_t first) : topology_(topology), first_(first) {}
    Iterator begin() const { return {&topology_, first_, first_}; }
    Iterator end() const { return {&topology_, first_, -1}; }

   private:
    const Topology& topology_;
    std::int32_t first_;
  };
  OutgoingHalfEdges halfEdgesFrom(std::int32_t v) const { return {*this, outgoing(v)}; }

  VertexTag vertexTag(std::int32_t v) const {
    return a_.vertexTags.empty() ? VertexTag::interior : a_.vertexTags[index(v)];
  }
  bool onBoundary(std::int32_t v) const { return vertexTag(v) != VertexTag::interior; }
  /// Number of edges at v: walks round it.
  std::int32_t valence(std::int32_t v) const;
  /// Number of faces at v: walks round it.
  std::int32_t facesAt(std::int32_t v) const;

  /// Is v inside, or on the boundary with two faces or more?
  bool keepsFace(std::int32_t v) const { return nextOutgoing(outgoing(v)) >= 0; }

  /// The boundary half-edge that enters a boundary vertex: walks round it.
  std::int32_t enteringBoundary(std::int32_t v) const;
  /// The run of face f, by bisection.
  const FaceRun& run(std::int32_t f) const;
  /// What face f was made from.
  FaceParent parentKind(std::int32_t f) const { return run(f).parent; }

  /// Bytes held by the arrays.
  std::int64_t byteCount() const;

  /// The arrays, to make another topology of.
  const TopologyArrays& arrays() const& { return a_; }
  TopologyArrays arrays() && { return std::move(a_); }

  /// At level 0: the caller's number of face f.
  std::int32_t inputFace(std::int32_t f) const { return a_.parents[index(f)]; }

 private:
  static constexpr std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }
  TopologyArrays a_;
};

/// Ranks of the boundary half-edges: rank[h] is the place of h in topology.boundary(), -1 inside. Empty when closed.
std::vector<std::int32_t> boundaryRanks(const Topology& topology);

}  // namespace honeycomb::Far
