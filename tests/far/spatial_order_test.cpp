// The spatial order of control faces: a permutation that brings neighbours near each other and changes nothing else.
#include "far/topology/spatial_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "tests/support/mesh_compare.h"
#include "tests/support/random.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

Far::Topology spatial(const PolyMesh& mesh) {
  auto topology = Far::Topology::create(toPolygons(mesh), Far::FaceOrder::spatial);
  if (!topology) throw std::runtime_error(topology.error().message);
  return *topology;
}

std::vector<std::int32_t> sorted(std::span<const std::int32_t> numbers) {
  std::vector<std::int32_t> result(numbers.begin(), numbers.end());
  std::sort(result.begin(), result.end());
  return result;
}

PolyMesh shuffled(PolyMesh mesh) {
  Random random(3);
  random.shuffle(mesh.faces);
  return mesh;
}

/// How far apart the numbers of two faces with a common edge are, on average.
double meanGap(const Far::Topology& topology) {
  double sum = 0, count = 0;
  for (std::int32_t h = 0; h < topology.halfEdgeCount(); ++h) {
    if (topology.twin(h) < 0) continue;
    sum += std::abs(topology.face(h) - topology.face(topology.twin(h)));
    ++count;
  }
  return sum / count;
}

TEST(SpatialOrder, NamesEveryFaceOfAnyMeshOnceAndKeepsItsLoop) {
  for (std::uint64_t seed = 0; seed < meshes(60); ++seed) {
    SCOPED_TRACE(seed);
    const PolyMesh mesh = randomMesh(seed).mesh;
    const Far::Topology topology = spatial(mesh);
    std::vector<std::int32_t> all(mesh.faces.size());
    std::iota(all.begin(), all.end(), 0);
    ASSERT_EQ(sorted(topology.parents()), all);
    for (std::int32_t f = 0; f < topology.faceCount(); ++f) {
      std::vector<std::size_t> loop;
      for (const std::int32_t h : topology.halfEdgesOf(f)) loop.push_back(static_cast<std::size_t>(topology.vert(h)));
      ASSERT_EQ(loop, at(mesh.faces, topology.inputFace(f))) << "face " << f;
    }
  }
}

TEST(SpatialOrder, VerticesFollowTheHalfEdgesThatLeaveThem) {
  for (std::uint64_t seed = 0; seed < meshes(20); ++seed) {
    const Far::Topology topology = spatial(randomMesh(seed).mesh);
    const std::vector<std::int32_t> order = Far::spatialVertexOrder(topology);
    std::vector<std::int32_t> all(static_cast<std::size_t>(topology.vertexCount()));
    std::iota(all.begin(), all.end(), 0);
    ASSERT_EQ(sorted(order), all) << "seed " << seed;
    const auto first = [&](std::int32_t v) { return std::find(topology.vert().begin(), topology.vert().end(), v); };
    for (std::size_t k = 1; k < order.size(); ++k) ASSERT_LT(first(order[k - 1]), first(order[k])) << "seed " << seed;
  }
}

TEST(SpatialOrder, IsTheSameEveryTime) {
  const PolyMesh mesh = shuffled(torus(70, 50));
  EXPECT_EQ(sorted(spatial(mesh).parents()).size(), 3500U);
  EXPECT_TRUE(std::ranges::equal(spatial(mesh).parents(), spatial(mesh).parents()));
}

TEST(SpatialOrder, GivesTheSameSurface) {
  const SchemeCase scheme = schemeCase(NamedTension::paper);
  for (std::uint64_t seed = 0; seed < meshes(20); ++seed) {
    SCOPED_TRACE(seed);
    const PolyMesh mesh = randomMesh(seed).mesh;
    const auto inOrder = Far::refine(spatial(mesh), scheme.scheme, 2);
    ASSERT_TRUE(inOrder) << inOrder.error().message;
    const MeshMatch match = matchMeshes(levelMesh(*inOrder, 2, mesh.points),
                                        levelMesh(refined(mesh, scheme.scheme, 2), 2, mesh.points), 1e-13);
    ASSERT_TRUE(match.same) << match.why;
  }
}

TEST(SpatialOrder, BringsNeighboursTogether) {
  const PolyMesh mesh = shuffled(grid(128, 128));
  const double random = meanGap(toTopology(mesh)), rows = meanGap(toTopology(grid(128, 128)));
  EXPECT_GT(random, 5000);
  EXPECT_LT(meanGap(spatial(mesh)), random / 12);
  // The share of edges whose faces aren't in one run of 64 is what a cache sees: rows cut every edge between them.
  const auto apart = [](const Far::Topology& topology) {
    std::int32_t count = 0;
    for (std::int32_t h = 0; h < topology.halfEdgeCount(); ++h) {
      if (topology.twin(h) >= 0 && std::abs(topology.face(h) - topology.face(topology.twin(h))) >= 64) ++count;
    }
    return static_cast<double>(count) / topology.halfEdgeCount();
  };
  EXPECT_GT(rows, 32);
  EXPECT_GT(apart(toTopology(mesh)), 0.9);
  EXPECT_LT(apart(spatial(mesh)), 0.3);
}

}  // namespace
}  // namespace honeycomb::Test
