#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "far/base/array.h"
#include "far/base/result.h"
#include "far/topology/polygons.h"
#include "far/topology/topology_state.h"

namespace honeycomb::Far {

/// The order of faces of one side count at level 0: the caller's, or one in which neighbours are near each other, so
/// that evaluation finds in the cache what it needs, also where the caller's order is random. The surface is the same,
/// its refined vertices and faces are numbered in another order.
enum class FaceOrder : std::uint8_t { input, spatial };

/// The connectivity of one level: half-edges stored as the concatenated loops of faces sorted into runs, so that a
/// half-edge's id is its place, and `next` and `prev` need no storage. Immutable; copies share their arrays.
///
/// The links (twin, face, outgoing, and all that walks by them) of a level that a split leaves without are found when
/// first asked for, linear in the half-edges and on all threads; evaluation and triangles don't ask. They may be
/// asked for from several threads at once.
///
/// Vertices keep the caller's numbers at level 0; faces are sorted stably by side count, inputFace() leads back,
/// whatever their order was before.
class Topology {
 public:
  Topology() : Topology(TopologyArrays{}) {}
  explicit Topology(TopologyArrays arrays) : state_(std::make_shared<TopologyState>(std::move(arrays))) {}

  /// Level 0 from polygons, fully validated. The error names the first defect and how many there are
  /// (findDefects lists them all); its element is the face, or the vertex of a bow-tie or isolated vertex.
  /// Linear in the number of corners, save a sort within the corners of each vertex.
  static Result<Topology> create(const Polygons& polygons, FaceOrder order = FaceOrder::input);

  std::int32_t vertexCount() const { return loops().vertexCount; }
  std::int32_t faceCount() const { return static_cast<std::int32_t>(loops().parents.size()); }
  std::int32_t halfEdgeCount() const { return static_cast<std::int32_t>(loops().vert.size()); }
  std::int32_t boundaryEdgeCount() const { return static_cast<std::int32_t>(loops().boundary.size()); }
  std::int32_t edgeCount() const { return (halfEdgeCount() + boundaryEdgeCount()) / 2; }
  /// V - E + F.
  std::int32_t eulerCharacteristic() const { return vertexCount() - edgeCount() + faceCount(); }
  bool closed() const { return loops().boundary.empty(); }
  /// Closed, and every vertex has three edges (known of refined levels; level 0 does not look).
  bool threeValent() const { return loops().threeValent; }

  std::span<const FaceRun> runs() const { return loops().runs; }
  std::span<const std::int32_t> vert() const { return loops().vert; }
  std::span<const std::int32_t> twin() const { return links().twin; }
  std::span<const std::int32_t> face() const { return links().face; }
  std::span<const std::int32_t> faceOffsets() const { return loops().faceOffsets; }
  std::span<const std::int32_t> outgoing() const { return links().outgoing; }
  std::span<const std::int32_t> parents() const { return loops().parents; }
  std::span<const std::int32_t> boundary() const { return loops().boundary; }
  std::span<const EdgeTag> boundaryTags() const { return loops().boundaryTags; }

  /// The vertex that half-edge h leaves.
  std::int32_t vert(std::int32_t h) const { return loops().vert[index(h)]; }
  /// The half-edge the other way; -1 on a boundary.
  std::int32_t twin(std::int32_t h) const { return links().twin[index(h)]; }
  /// The face to the left of half-edge h.
  std::int32_t face(std::int32_t h) const { return links().face[index(h)]; }
  /// A half-edge that leaves vertex v; on a boundary the boundary one.
  std::int32_t outgoing(std::int32_t v) const { return links().outgoing[index(v)]; }
  /// The number of sides of face f.
  std::int32_t sides(std::int32_t f) const { return loops().faceOffsets[index(f) + 1] - loops().faceOffsets[index(f)]; }
  /// The half-edge after h in its face.
  std::int32_t next(std::int32_t h) const {
    const std::size_t f = index(face(h));
    return h + 1 == loops().faceOffsets[f + 1] ? loops().faceOffsets[f] : h + 1;
  }
  /// The half-edge before h in its face.
  std::int32_t prev(std::int32_t h) const {
    const std::size_t f = index(face(h));
    return h == loops().faceOffsets[f] ? loops().faceOffsets[f + 1] - 1 : h - 1;
  }
  /// The vertex that half-edge h goes to.
  std::int32_t dest(std::int32_t h) const { return vert(next(h)); }
  /// Does h stand for its edge: the lower of its two half-edges, or the only one?
  bool leads(std::int32_t h) const { return twin(h) < 0 || h < twin(h); }
  /// The next outgoing half-edge counter-clockwise round vert(h); -1 past the last face of a boundary vertex.
  std::int32_t nextOutgoing(std::int32_t h) const { return twin(prev(h)); }

  std::span<const CreaseEdge> creases() const { return loops().creases; }
  std::span<const std::int32_t> heldCorners() const { return loops().heldCorners; }

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
  /// All half-edges of face f.
  FaceHalfEdges halfEdgesOf(std::int32_t f) const {
    return {loops().faceOffsets[index(f)], loops().faceOffsets[index(f) + 1]};
  }

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
  /// All half-edges that leave vertex v.
  OutgoingHalfEdges halfEdgesFrom(std::int32_t v) const { return {*this, outgoing(v)}; }

  /// Where vertex v is on the boundary, if it is.
  VertexTag vertexTag(std::int32_t v) const {
    return loops().vertexTags.empty() ? VertexTag::interior : loops().vertexTags[index(v)];
  }
  /// Has vertex v a boundary edge?
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

  /// The arrays, links and all, to make another topology of.
  TopologyArrays arrays() const&;
  /// The same, taken away where no copy shares them.
  TopologyArrays arrays() &&;

  /// How the links are found, where the split leaves them out.
  LinkRule linkRule() const { return loops().linkRule; }
  /// vert(), kept with its level for as long as the array is held.
  std::shared_ptr<const Array<std::int32_t>> sharedVert() const { return {state_, &loops().vert}; }

  /// At level 0: the caller's number of face f.
  std::int32_t inputFace(std::int32_t f) const { return loops().parents[index(f)]; }

 private:
  static constexpr std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }
  const TopologyArrays& loops() const { return state_->loops(); }
  const HalfEdgeLinks& links() const { return state_->links(); }
  std::shared_ptr<TopologyState> state_;
};

/// Ranks of the boundary half-edges: rank[h] is the place of h in topology.boundary(), -1 inside. Empty when closed.
std::vector<std::int32_t> boundaryRanks(const Topology& topology);

}  // namespace honeycomb::Far
