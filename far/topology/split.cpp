#include "far/topology/split.h"

#include "far/base/index.h"

namespace honeycomb::Far {

namespace {

void countBoundaryEdge(const Topology& topology, std::size_t rank, Census& census) {
  const std::int32_t h = topology.boundary()[rank];
  const std::int32_t tip =
      topology.vertexTag(topology.vert(h)) == VertexTag::fixedCorner ? topology.dest(h) : topology.vert(h);
  const bool mid = topology.vertexTag(tip) == VertexTag::mid;
  switch (topology.boundaryTags()[rank]) {
    case EdgeTag::onLine:
      ++census.onLine;
      break;
    case EdgeTag::cut:
      ++(mid ? census.cutMid : census.cutReal);
      break;
    case EdgeTag::cutToCorner:
      ++(mid ? census.tipMid : census.tipReal);
      break;
  }
}

}  // namespace

Census takeCensus(const Topology& topology) {
  Census census;
  census.vertices = topology.vertexCount();
  census.edges = topology.edgeCount();
  census.faces = topology.faceCount();
  census.halfEdges = topology.halfEdgeCount();
  census.boundaryEdges = topology.boundaryEdgeCount();
  for (const FaceRun& run : topology.runs()) {
    if (run.kind == FaceKind::clampedGap) census.gaps += run.faceCount;
  }
  for (std::size_t rank = 0; rank < topology.boundary().size(); ++rank) {
    countBoundaryEdge(topology, rank, census);
    switch (topology.vertexTag(topology.vert(topology.boundary()[rank]))) {
      case VertexTag::real:
        ++census.real;
        break;
      case VertexTag::mid:
        ++census.mid;
        break;
      case VertexTag::corner:
        ++census.corner;
        break;
      case VertexTag::fixedCorner:
        ++census.fixedCorner;
        break;
      case VertexTag::interior:
        break;
    }
  }
  return census;
}

}  // namespace honeycomb::Far
