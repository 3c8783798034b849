#include "far/topology/splits/closed_split.h"

#include <algorithm>

#include "far/base/index.h"
#include "far/base/parallel.h"

namespace honeycomb::Far {

namespace {

/// Half-edges whose edges are counted by one task.
constexpr std::int64_t kPiece = 16384;

}  // namespace

void appendRun(std::vector<FaceRun>& runs, const FaceRun& run) {
  if (run.faceCount == 0) return;
  const bool same = !runs.empty() && runs.back().kind == run.kind && runs.back().parent == run.parent &&
                    runs.back().sides == run.sides;
  if (same) {
    runs.back().faceCount += run.faceCount;
  } else {
    runs.push_back(run);
  }
}

void appendFaceRuns(const Topology& parent, std::int32_t factor, std::vector<FaceRun>& runs) {
  for (FaceRun run : parent.runs()) {
    run.kind = FaceKind::full;
    run.parent = FaceParent::face;
    run.sides *= factor;
    run.firstHalfEdge *= factor;
    appendRun(runs, run);
  }
}

void writeFaceFaces(const Topology& parent, std::int32_t factor, TopologyArrays& child) {
  Parallel::forEach(0, parent.faceCount(), [&](std::int64_t f) {
    child.faceOffsets[at(f)] = factor * parent.faceOffsets()[at(f)];
    child.parents[at(f)] = static_cast<std::int32_t>(f);
  });
}

void resizeLoops(TopologyArrays& child, std::int32_t halfEdges, std::int32_t faces) {
  child.vert.resize(at(halfEdges));
  child.faceOffsets.resize(at(faces) + 1);
  child.faceOffsets.back() = halfEdges;
  child.parents.resize(at(faces));
}

void resizeArrays(TopologyArrays& child, std::int32_t halfEdges, std::int32_t faces, std::int32_t vertices) {
  resizeLoops(child, halfEdges, faces);
  child.twin.resize(at(halfEdges));
  child.face.resize(at(halfEdges));
  child.outgoing.resize(at(vertices));
  child.vertexCount = vertices;
}

VertexBlocks::VertexBlocks(const Topology& parent, std::int32_t factor, std::int32_t firstFace,
                           std::int32_t firstHalfEdge)
    : firstFace_(firstFace), firstHalfEdge_(firstHalfEdge) {
  std::int32_t valence = 3;
  Array<std::int32_t> valences;
  if (!parent.threeValent()) {
    valences.resize(at(parent.vertexCount()));
    Parallel::forEach(0, parent.vertexCount(),
                      [&](std::int64_t v) { valences[at(v)] = parent.facesAt(static_cast<std::int32_t>(v)); });
    const auto [least, most] = std::minmax_element(valences.begin(), valences.end());
    if (*least != *most) {
      sort(valences, factor);
      return;
    }
    valence = *most;
  }
  sides_ = factor * valence;
  runs_.push_back({FaceKind::full, FaceParent::vertex, sides_, firstFace, firstHalfEdge, parent.vertexCount()});
}

void VertexBlocks::sort(const Array<std::int32_t>& valences, std::int32_t factor) {
  const std::int32_t most = *std::max_element(valences.begin(), valences.end());
  const Array<std::int32_t> order = Parallel::stableOrder(valences, most + 1);
  faces_.resize(order.size());
  halfEdges_.resize(order.size());
  std::int32_t halfEdge = firstHalfEdge_;
  for (auto begin = order.begin(); begin != order.end();) {
    const std::int32_t valence = valences[at(*begin)];
    const auto end = std::upper_bound(begin, order.end(), valence,
                                      [&](std::int32_t key, std::int32_t v) { return key < valences[at(v)]; });
    const std::int32_t sides = factor * valence;
    const auto first = static_cast<std::int32_t>(begin - order.begin());
    const auto count = static_cast<std::int32_t>(end - begin);
    runs_.push_back({FaceKind::full, FaceParent::vertex, sides, firstFace_ + first, halfEdge, count});
    Parallel::forEach(0, count, [&](std::int64_t i) {
      const std::size_t v = at(order[at(first + i)]);
      faces_[v] = firstFace_ + first + static_cast<std::int32_t>(i);
      halfEdges_[v] = halfEdge + sides * static_cast<std::int32_t>(i);
    });
    halfEdge += sides * count;
    begin = end;
  }
}

EdgeRanks::EdgeRanks(const Topology& parent) : halves_(at(parent.halfEdgeCount())) {
  const std::int64_t halfEdges = parent.halfEdgeCount();
  std::vector<std::int32_t> edges(at((halfEdges + kPiece - 1) / kPiece));
  const auto visitPieces = [&](const auto& visit) {
    Parallel::forEach(
        0, static_cast<std::int64_t>(edges.size()),
        [&](std::int64_t p) {
          std::int32_t edge = edges[at(p)];
          const auto end = static_cast<std::int32_t>(std::min(halfEdges, (p + 1) * kPiece));
          for (auto h = static_cast<std::int32_t>(p * kPiece); h < end; ++h) {
            if (h < parent.twin(h)) visit(h, edge++);
          }
          edges[at(p)] = edge;
        },
        1);
  };
  visitPieces([](std::int32_t, std::int32_t) {});
  Parallel::exclusiveScan(edges);
  visitPieces([&](std::int32_t h, std::int32_t edge) {
    halves_[at(h)] = 2 * edge + 1;
    halves_[at(parent.twin(h))] = 2 * edge;
  });
}

}  // namespace honeycomb::Far
