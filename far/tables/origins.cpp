#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/tables/refinement.h"

namespace honeycomb::Far {

namespace {

std::vector<Origin> baseFaces(const Topology& base) {
  std::vector<Origin> origins(at(base.faceCount()));
  for (std::size_t f = 0; f < origins.size(); ++f) origins[f] = {static_cast<std::int32_t>(f), 0, false};
  return origins;
}

std::vector<Origin> baseVertices(const Topology& base) {
  std::vector<Origin> origins(at(base.vertexCount()));
  for (std::size_t v = 0; v < origins.size(); ++v) origins[v] = {static_cast<std::int32_t>(v), 0, true};
  return origins;
}

/// The face of the level before in which each vertex was made: that of the half-edge it leaves in a face-face.
std::vector<Origin> vertexOriginsFrom(const Level& level, const std::vector<Origin>& parentFaces,
                                      const std::vector<Origin>& faces) {
  const Topology& topology = level.topology;
  std::vector<Origin> origins(at(topology.vertexCount()));
  Parallel::forEach(0, topology.vertexCount(), [&](std::int64_t v) {
    for (const std::int32_t h : topology.halfEdgesFrom(static_cast<std::int32_t>(v))) {
      const std::int32_t f = topology.face(h);
      if (topology.parentKind(f) == FaceParent::face) {
        origins[at(v)] = parentFaces[at(topology.parents()[at(f)])];
        return;
      }
    }
    origins[at(v)] = faces[at(topology.face(topology.outgoing()[at(v)]))];
  });
  return origins;
}

struct LevelOrigins {
  std::vector<Origin> faces, vertices;
};

/// The origin of a parent; an edge's is that of the face its lower half-edge lies in.
Origin parentOrigin(const Topology& level, const LevelOrigins& origins, FaceParent kind, std::int32_t parent) {
  switch (kind) {
    case FaceParent::face:
      return origins.faces[at(parent)];
    case FaceParent::vertex:
      return origins.vertices[at(parent)];
    default:
      return origins.faces[at(level.face(parent))];
  }
}

LevelOrigins originsOf(const Refinement& refinement, std::int32_t k) {
  LevelOrigins origins{baseFaces(refinement.level(0).topology), baseVertices(refinement.level(0).topology)};
  for (std::int32_t level = 1; level <= k; ++level) {
    const Topology& topology = refinement.level(level).topology;
    std::vector<Origin> faces(at(topology.faceCount()));
    for (const FaceRun& run : topology.runs()) {
      Parallel::forEach(run.firstFace, run.firstFace + run.faceCount, [&](std::int64_t f) {
        const std::int32_t parent = topology.parents()[at(f)];
        faces[at(f)] = parentOrigin(refinement.level(level - 1).topology, origins, run.parent, parent);
        if (run.parent != FaceParent::face) faces[at(f)].level = level;
      });
    }
    std::vector<Origin> vertices = vertexOriginsFrom(refinement.level(level), origins.faces, faces);
    origins = {std::move(faces), std::move(vertices)};
  }
  return origins;
}

}  // namespace

std::vector<Origin> Refinement::faceOrigins(std::int32_t k) const {
  return originsOf(*this, k).faces;
}

std::vector<Origin> Refinement::vertexOrigins(std::int32_t k) const {
  return originsOf(*this, k).vertices;
}

}  // namespace honeycomb::Far
