#include <gtest/gtest.h>

#include <span>
#include <vector>

#include "far/base/parallel.h"
#include "tests/support/refined.h"
#include "tests/support/scheme_list.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

template <class T>
std::vector<T> copy(std::span<const T> values) {
  return {values.begin(), values.end()};
}

void expectSame(const Far::Level& a, const Far::Level& b) {
  EXPECT_EQ(copy(a.topology.runs()), copy(b.topology.runs()));
  EXPECT_EQ(copy(a.topology.vert()), copy(b.topology.vert()));
  EXPECT_EQ(copy(a.topology.twin()), copy(b.topology.twin()));
  EXPECT_EQ(copy(a.topology.face()), copy(b.topology.face()));
  EXPECT_EQ(copy(a.topology.outgoing()), copy(b.topology.outgoing()));
  EXPECT_EQ(copy(a.topology.parents()), copy(b.topology.parents()));
  EXPECT_EQ(copy(a.topology.boundary()), copy(b.topology.boundary()));
  EXPECT_EQ(copy(a.topology.boundaryTags()), copy(b.topology.boundaryTags()));
  EXPECT_EQ(a.table.indices, b.table.indices);
  EXPECT_EQ(a.table.weights, b.table.weights);
  EXPECT_EQ(a.table.loose.outputs, b.table.loose.outputs);
  EXPECT_EQ(a.table.loose.offsets, b.table.loose.offsets);
}

TEST(Determinism, OneAndTwoThreadsBuildTheSameArrays) {
  for (const PolyMesh& mesh : {torus(60, 50), grid(70, 40), prism(9000), fan(6000)}) {
    const auto build = [&mesh](int threads) {
      const Parallel::ThreadLimit limit(threads);
      return refined(mesh, schemeCase(NamedTension::paper).scheme, 2, {}, true);
    };
    const Far::Refinement one = build(1);
    const Far::Refinement two = build(2);
    for (std::int32_t k = 0; k <= 2; ++k) expectSame(one.level(k), two.level(k));
    for (const auto part : {&Far::LimitTable::faces, &Far::LimitTable::vertices, &Far::LimitTable::verticesHere}) {
      EXPECT_EQ((one.limits().*part).elements, (two.limits().*part).elements);
      EXPECT_EQ((one.limits().*part).indices, (two.limits().*part).indices);
      EXPECT_EQ((one.limits().*part).weights, (two.limits().*part).weights);
    }
    EXPECT_EQ(one.triangles(2), two.triangles(2));
    EXPECT_EQ(one.lines(2), two.lines(2));
    EXPECT_EQ(one.faceOrigins(2), two.faceOrigins(2));
    EXPECT_EQ(one.vertexOrigins(2), two.vertexOrigins(2));
  }
}

TEST(Determinism, LinksAskedForFromParallelLoopsAreTheSame) {
  const Far::Topology control = toTopology(torus(60, 50));
  const Far::Topology asked = Far::refine(control, schemeCase(NamedTension::paper).scheme, 2)->last().topology;
  const Far::Topology later = Far::refine(control, schemeCase(NamedTension::paper).scheme, 2)->last().topology;
  std::vector<std::int32_t> twins(static_cast<std::size_t>(later.halfEdgeCount()));
  Parallel::forEach(
      0, later.halfEdgeCount(),
      [&](std::int64_t h) { twins[static_cast<std::size_t>(h)] = later.twin(static_cast<std::int32_t>(h)); }, 16);
  EXPECT_EQ(twins, copy(asked.twin()));
}

TEST(Determinism, OneAndTwoThreadsBuildTheSameArraysInEveryScheme) {
  for (const ListedScheme& scheme : listedSchemes()) {
    SCOPED_TRACE(scheme.name);
    for (const PolyMesh& mesh : {torus(60, 50), grid(50, 40)}) {
      const auto build = [&](int threads) {
        const Parallel::ThreadLimit limit(threads);
        return refinedBy(scheme, toTopology(mesh), 2);
      };
      const Far::Refinement one = build(1);
      const Far::Refinement two = build(2);
      for (std::int32_t k = 0; k <= one.levelCount(); ++k) expectSame(one.level(k), two.level(k));
    }
  }
}

}  // namespace
}  // namespace honeycomb::Test
