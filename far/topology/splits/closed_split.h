#pragma once

#include <cstdint>
#include <vector>

#include "far/base/array.h"
#include "far/topology/split.h"

/// What the closed forms of the splits share: on a mesh without a boundary every slot is alive, so that where it goes
/// is index algebra, and each array of the next level is written in place by parallel loops. The numbering is
/// assemble()'s.
namespace honeycomb::Far {

/// Appends a run of faces; one of the same kind, parent and side count as the run before it prolongs that.
void appendRun(std::vector<FaceRun>& runs, const FaceRun& run);

/// Appends the runs of the faces that the parent's faces become, with `factor` sides a side.
void appendFaceRuns(const Topology& parent, std::int32_t factor, std::vector<FaceRun>& runs);

/// Writes faceOffsets and parents of those faces: f's at f, with `factor` sides a side.
void writeFaceFaces(const Topology& parent, std::int32_t factor, TopologyArrays& child);

/// Makes room for the loops of so many half-edges and faces.
void resizeLoops(TopologyArrays& child, std::int32_t halfEdges, std::int32_t faces);
/// The same and for the links, of so many vertices.
void resizeArrays(TopologyArrays& child, std::int32_t halfEdges, std::int32_t faces, std::int32_t vertices);

/// Where the loops of the faces go that the parent's vertices become, `factor` sides an edge: blocks sorted stably by
/// valence, behind a first face and half-edge.
class VertexBlocks {
 public:
  VertexBlocks(const Topology& parent, std::int32_t factor, std::int32_t firstFace, std::int32_t firstHalfEdge);

  void appendRuns(std::vector<FaceRun>& runs) const {
    for (const FaceRun& run : runs_) appendRun(runs, run);
  }

  std::int32_t face(std::int32_t v) const { return sides_ > 0 ? firstFace_ + v : faces_[index(v)]; }
  std::int32_t halfEdge(std::int32_t v) const {
    return sides_ > 0 ? firstHalfEdge_ + sides_ * v : halfEdges_[index(v)];
  }

 private:
  static constexpr std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }
  void sort(const Array<std::int32_t>& valences, std::int32_t factor);

  std::int32_t firstFace_, firstHalfEdge_;
  std::int32_t sides_ = 0;  // where all vertices have the same valence
  Array<std::int32_t> faces_, halfEdges_;
  std::vector<FaceRun> runs_;
};

/// The edges of a closed mesh numbered by their lower half-edges, as assemble() numbers what edges become.
class EdgeRanks {
 public:
  explicit EdgeRanks(const Topology& parent);

  /// The edge of h, from 0.
  std::int32_t edge(std::int32_t h) const { return half(h) / 2; }
  /// Twice the edge, and one more for the lower of its half-edges.
  std::int32_t half(std::int32_t h) const { return halves_[static_cast<std::size_t>(h)]; }
  bool leads(std::int32_t h) const { return half(h) % 2 != 0; }

 private:
  Array<std::int32_t> halves_;
};

}  // namespace honeycomb::Far
