#include "tests/fuzz/read_mesh.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "far/base/index.h"
#include "far/topology/topology.h"

namespace honeycomb::Fuzz {
namespace {

bool finite(std::span<const double> numbers) {
  return std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); });
}

/// -1 stands for none.
bool leadInto(std::span<const std::int32_t> corners, std::size_t items) {
  return std::ranges::all_of(corners, [items](std::int32_t i) { return i >= -1 && (i < 0 || at(i) < items); });
}

void expectSoundPolygons(const Far::Polygons& polygons) {
  const auto& offsets = polygons.faceOffsets;
  expect(polygons.vertexCount > 0 && polygons.faceCount() > 0, "a mesh has vertices and faces");
  expect(offsets.front() == 0 && offsets.back() == std::ssize(polygons.indices), "faces take all corners");
  const auto tooFew = [](std::int64_t from, std::int64_t to) { return to - from < 3; };
  expect(std::ranges::adjacent_find(offsets, tooFew) == offsets.end(), "a face has three sides or more");
  const auto inside = [&polygons](std::int32_t v) { return v >= 0 && v < polygons.vertexCount; };
  expect(std::ranges::all_of(polygons.indices, inside), "corners are vertices");
  expect(std::ranges::all_of(polygons.corners, inside), "tagged corners are vertices");
  const auto sound = [&inside](const Far::Crease& crease) { return inside(crease.vertex0) && inside(crease.vertex1); };
  expect(std::ranges::all_of(polygons.creases, sound), "creases are edges between vertices");
}

}  // namespace

void useMesh(const Result<Io::Mesh>& mesh) {
  if (!mesh) {
    expect(mesh.error().message.starts_with("a.mesh:"), "a refusal names the file");
    return;
  }
  const Far::Polygons& polygons = mesh->polygons;
  expectSoundPolygons(polygons);
  expect(mesh->positions.size() == 3 * at(polygons.vertexCount), "a position a vertex");
  expect(mesh->colours.empty() || mesh->colours.size() == mesh->positions.size(), "a colour a vertex, or none");
  for (const auto& numbers : {mesh->positions, mesh->colours, mesh->texcoords, mesh->normals})
    expect(finite(numbers), "numbers are finite");
  for (const auto& corners : {mesh->cornerTexcoords, mesh->cornerNormals})
    expect(corners.empty() || corners.size() == polygons.indices.size(), "corners have one number each");
  expect(leadInto(mesh->cornerTexcoords, mesh->texcoords.size() / 2), "texture coordinates of corners exist");
  expect(leadInto(mesh->cornerNormals, mesh->normals.size() / 3), "normals of corners exist");
  const auto topology = Far::Topology::create(polygons);
  expect(topology.has_value() || !topology.error().message.empty(), "what is no manifold is refused with a message");
}

}  // namespace honeycomb::Fuzz
