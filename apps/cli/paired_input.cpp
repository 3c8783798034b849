#include "apps/cli/paired_input.h"

#include <fmt/format.h>

#include "far/base/index.h"
#include "far/conversions/pair_triangles.h"

namespace honeycomb::Cli {
namespace {

template <class Number>
std::vector<Number> picked(const std::vector<Number>& values, const std::vector<std::int64_t>& places) {
  if (values.empty()) return {};
  std::vector<Number> result;
  result.reserve(places.size());
  for (const std::int64_t place : places) result.push_back(values[at(place)]);
  return result;
}

}  // namespace

void pairTriangles(MeshInput& input) {
  Io::Mesh& mesh = input.mesh;
  Far::TrianglePairing paired = Far::pairTriangles(mesh.polygons, mesh.positions, mesh.cornerTexcoords);
  input.notes.push_back(fmt::format("{} made of pairs of triangles", counted(paired.quads, "quad")));
  mesh.cornerTexcoords = picked(mesh.cornerTexcoords, paired.sourceCorners);
  mesh.cornerNormals = picked(mesh.cornerNormals, paired.sourceCorners);
  mesh.faceLines = picked(mesh.faceLines, paired.sourceFaces);
  mesh.polygons = std::move(paired.polygons);
}

}  // namespace honeycomb::Cli
