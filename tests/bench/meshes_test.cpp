#include "bench/kit/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

#include "far/base/index.h"
#include "far/topology/topology.h"

namespace honeycomb::Bench {
namespace {

Far::Topology topologyOf(const Mesh& mesh) {
  Result<Far::Topology> topology = Far::Topology::create(mesh.polygons);
  EXPECT_TRUE(topology) << topology.error().message;
  return std::move(*topology);
}

std::map<std::int32_t, int> sidesOf(const Far::Topology& topology) {
  std::map<std::int32_t, int> sides;
  for (std::int32_t f = 0; f < topology.faceCount(); ++f) ++sides[topology.sides(f)];
  return sides;
}

TEST(BenchMeshes, ATorusHasTheFacesAskedForWhereTheirNumberHasEvenFactors) {
  for (const std::int32_t faces : {16, 64, 1000, 10'000, 100'000}) {
    const Far::Topology torusTopology = topologyOf(torus(faces));
    EXPECT_EQ(torusTopology.faceCount(), faces);
    EXPECT_EQ(torusTopology.vertexCount(), faces);
    EXPECT_TRUE(torusTopology.closed());
    EXPECT_EQ(torusTopology.eulerCharacteristic(), 0);
  }
}

TEST(BenchMeshes, AnyNumberOfFacesIsMetFromBelowWithinARow) {
  for (const std::int32_t faces : {17, 997, 5626, 99'991}) {
    const std::int32_t found = topologyOf(torus(faces)).faceCount();
    EXPECT_LE(found, faces);
    EXPECT_GT(found, faces - 2 * static_cast<std::int32_t>(std::sqrt(faces)));
  }
}

TEST(BenchMeshes, AMixedMeshIsAClosedTorusOfFourKindsOfFaces) {
  for (const std::int32_t faces : {16, 90, 1000, 10'000}) {
    const Far::Topology mixedTopology = topologyOf(mixed(faces));
    EXPECT_TRUE(mixedTopology.closed());
    EXPECT_EQ(mixedTopology.eulerCharacteristic(), 0);
    EXPECT_NEAR(mixedTopology.faceCount(), faces, 0.5 * faces);
    for (std::int32_t v = 0; v < mixedTopology.vertexCount(); ++v) {
      EXPECT_GE(mixedTopology.valence(v), 3) << v;
      EXPECT_LE(mixedTopology.valence(v), 6) << v;
    }
  }
  const std::map<std::int32_t, int> sides = sidesOf(topologyOf(mixed(1000)));
  EXPECT_THAT(sides, testing::ElementsAre(testing::Key(3), testing::Key(4), testing::Key(5), testing::Key(6)));
}

/// Each face as the points of its loop, begun at the least, in ascending order.
std::vector<std::vector<std::array<double, 3>>> facesOf(const Mesh& mesh) {
  std::vector<std::vector<std::array<double, 3>>> faces;
  for (std::int64_t f = 0; f < mesh.polygons.faceCount(); ++f) {
    auto& loop = faces.emplace_back();
    for (std::int64_t i = mesh.polygons.faceOffsets[at(f)]; i < mesh.polygons.faceOffsets[at(f) + 1]; ++i) {
      const double* point = &mesh.points[3 * at(mesh.polygons.indices[at(i)])];
      loop.push_back({point[0], point[1], point[2]});
    }
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

TEST(BenchMeshes, AShuffledMeshHasTheSameFacesInAnotherOrder) {
  const Mesh mesh = mixed(200);
  const Mesh other = shuffled(mesh);
  EXPECT_EQ(other.name, "shuffled mixed");
  EXPECT_NE(other.polygons.indices, mesh.polygons.indices);
  EXPECT_NE(other.points, mesh.points);
  EXPECT_EQ(facesOf(other), facesOf(mesh));
  EXPECT_EQ(shuffled(mesh).points, other.points) << "the same seed gives the same order";
  EXPECT_NE(shuffled(mesh, 2).points, other.points);
}

TEST(BenchMeshes, ShufflingTakesCreasesAndCornersAlong) {
  Mesh mesh = torus(16);
  mesh.polygons.corners = {5};
  mesh.polygons.creases = {{2, 3, 1.5}};
  const Mesh other = shuffled(mesh);
  const auto point = [](const Mesh& of, std::int32_t v) {
    return std::vector<double>(of.points.begin() + 3 * v, of.points.begin() + 3 * v + 3);
  };
  EXPECT_EQ(point(other, other.polygons.corners.at(0)), point(mesh, 5));
  EXPECT_EQ(point(other, other.polygons.creases.at(0).vertex0), point(mesh, 2));
  EXPECT_EQ(point(other, other.polygons.creases.at(0).vertex1), point(mesh, 3));
  EXPECT_EQ(other.polygons.creases.at(0).sharpness, 1.5);
}

}  // namespace
}  // namespace honeycomb::Bench
