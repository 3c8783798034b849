#include "tests/support/creased.h"

#include <initializer_list>
#include <stdexcept>

#include "tests/support/refined.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

void addLine(std::initializer_list<std::int32_t> path, double sharpness, std::vector<Far::Crease>& creases) {
  for (auto v = path.begin(); v + 1 != path.end(); ++v) creases.push_back({v[0], v[1], sharpness});
}

}  // namespace

Far::Topology creased(const PolyMesh& mesh, const std::vector<Far::Crease>& creases,
                      const std::vector<std::size_t>& cornerTags) {
  Far::Polygons polygons = toPolygons(mesh, cornerTags);
  polygons.creases = creases;
  Result<Far::Topology> topology = Far::Topology::create(polygons);
  if (!topology) throw std::runtime_error(topology.error().message);
  return std::move(*topology);
}

Far::Refinement refinedBy(const Far::Topology& control, const std::vector<Far::Scheme>& chain, bool limits) {
  Result<Far::Refinement> refinement = Far::refine(control, chain, {.limits = limits, .memoryLimit = 0});
  if (!refinement) throw std::runtime_error(refinement.error().message);
  return std::move(*refinement);
}

std::vector<Far::Crease> creasesRound(const PolyMesh& mesh, std::size_t f, double sharpness) {
  std::vector<Far::Crease> creases;
  const Loop& loop = mesh.faces[f];
  for (std::size_t i = 0; i < loop.size(); ++i) {
    addLine({static_cast<std::int32_t>(loop[i]), static_cast<std::int32_t>(loop[(i + 1) % loop.size()])}, sharpness,
            creases);
  }
  return creases;
}

std::vector<Far::Crease> creasesEverywhere(const PolyMesh& mesh, double sharpness) {
  std::vector<Far::Crease> creases;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (const Far::Crease& crease : creasesRound(mesh, f, sharpness)) creases.push_back(crease);
  }
  return creases;
}

std::vector<CreasedMesh> creasedMeshes(double sharpness) {
  std::vector<Far::Crease> star;
  addLine({1, 6, 11, 12, 13}, sharpness, star);
  addLine({12, 17, 22}, sharpness, star);
  return {{"loop round a face of a cube", cube(), creasesRound(cube(), 0, sharpness)},
          {"loop round a face of a dodecahedron", dodecahedron(), creasesRound(dodecahedron(), 3, sharpness)},
          {"edge of a torus", torus(5, 6), {{0, 1, sharpness}}},
          {"every edge of a cube", cube(), creasesEverywhere(cube(), sharpness)},
          {"star on a grid with a border", grid(4, 4), star}};
}

std::vector<CreasedMesh> meetingCreases(std::size_t n, double sharpness) {
  const auto count = static_cast<std::int32_t>(n);
  std::vector<Far::Crease> posts;
  for (std::int32_t i = 0; i < count; ++i) addLine({i, count + i}, sharpness, posts);
  std::vector<Far::Crease> spokes;
  for (std::int32_t i = 0; i < count; i += 2) addLine({0, 1 + i}, sharpness, spokes);
  return {{"posts of a prism", prism(n), posts}, {"spokes of a wheel", wheel(n), spokes}};
}

PolyMesh detached(PolyMesh mesh, std::size_t f) {
  for (std::size_t& v : mesh.faces[f]) {
    mesh.points.push_back(mesh.points[v]);
    v = mesh.points.size() - 1;
  }
  return mesh;
}

std::string sidesDiffer(const Far::Level& level, const std::vector<Vec3>& points) {
  const Far::Topology& topology = level.topology;
  for (const Far::CreaseEdge& crease : topology.creases()) {
    const bool same = at(points, topology.vert(crease.halfEdge)) == at(points, topology.dest(crease.mate)) &&
                      at(points, topology.dest(crease.halfEdge)) == at(points, topology.vert(crease.mate));
    if (!same) return "half-edges " + std::to_string(crease.halfEdge) + " and " + std::to_string(crease.mate);
  }
  return {};
}

Far::Topology randomlyCreased(const RandomMesh& random, Random& choice, const std::vector<double>& values) {
  std::vector<Far::Crease> creases;
  const double share = 0.5 * choice.unit();
  const bool alike = choice.chance(0.3);
  const double value = values[choice.below(values.size())];
  for (const Loop& loop : random.mesh.faces) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto v = static_cast<std::int32_t>(loop[i]);
      const auto w = static_cast<std::int32_t>(loop[(i + 1) % loop.size()]);
      if (v < w && choice.chance(share)) creases.push_back({v, w, alike ? value : values[choice.below(values.size())]});
    }
  }
  return creased(random.mesh, creases, random.cornerTags);
}

}  // namespace honeycomb::Test
