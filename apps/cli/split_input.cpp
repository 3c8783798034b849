#include "apps/cli/split_input.h"

#include <fmt/format.h>

#include "far/base/index.h"
#include "far/conversions/split_non_manifold.h"

namespace honeycomb::Cli {
namespace {

/// The values of the corners of the faces that are left.
std::vector<std::int32_t> ofFaces(const std::vector<std::int32_t>& corners, const Far::Polygons& before,
                                  const std::vector<std::int64_t>& faces) {
  if (corners.empty()) return {};
  std::vector<std::int32_t> left;
  for (const std::int64_t f : faces)
    left.insert(left.end(), corners.begin() + before.faceOffsets[at(f)],
                corners.begin() + before.faceOffsets[at(f) + 1]);
  return left;
}

void noteSplit(MeshInput& input, const Far::ManifoldSplit& split, std::int64_t duplicates) {
  if (duplicates > 0)
    input.notes.push_back(fmt::format("{} of vertices made it a manifold: {} cut, {} parted",
                                      counted(duplicates, "duplicate"), counted(split.edgesCut, "edge"),
                                      counted(split.bowTies, "bow-tie")));
  if (split.facesLeftOut > 0)
    input.notes.push_back(
        fmt::format("{} left out: fewer than three corners, or one vertex twice", counted(split.facesLeftOut, "face")));
}

}  // namespace

void splitNonManifold(MeshInput& input) {
  Io::Mesh& mesh = input.mesh;
  Far::ManifoldSplit split = Far::splitNonManifold(mesh.polygons);
  const std::int64_t duplicates = split.duplicates(mesh.polygons.vertexCount);
  if (duplicates == 0 && split.facesLeftOut == 0) return;
  noteSplit(input, split, duplicates);
  mesh.cornerTexcoords = ofFaces(mesh.cornerTexcoords, mesh.polygons, split.sourceFaces);
  mesh.cornerNormals = ofFaces(mesh.cornerNormals, mesh.polygons, split.sourceFaces);
  if (!mesh.faceLines.empty()) {
    std::vector<std::int64_t> lines;
    for (const std::int64_t f : split.sourceFaces) lines.push_back(mesh.faceLines[at(f)]);
    mesh.faceLines = std::move(lines);
  }
  mesh.polygons = std::move(split.polygons);
  // The lines of tags no longer stand beside them one by one.
  mesh.creaseLines.assign(mesh.creaseLines.empty() ? 0 : mesh.polygons.creases.size(), 0);
  mesh.cornerLines.assign(mesh.cornerLines.empty() ? 0 : mesh.polygons.corners.size(), 0);
  gatherVertices(input, split.sourceVertices);
}

}  // namespace honeycomb::Cli
