#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "far/base/bytes.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

std::int64_t linkBytesOf(const Far::Topology& t) {
  return 4 * (2 * std::int64_t{t.halfEdgeCount()} + t.vertexCount());
}

Far::Refinement zipped(std::int32_t levels) {
  return refined(torus(6, 5), schemeCase(NamedTension::paper).scheme, levels);
}

TEST(Links, OfClosedZipLevelsComeWhenTheyAreAskedFor) {
  const Far::Refinement refinement = zipped(3);
  for (std::int32_t k = 1; k <= 3; ++k) {
    const Far::Topology& level = refinement.level(k).topology;
    const std::int64_t before = level.byteCount();
    (void)level.twin();
    EXPECT_EQ(level.byteCount(), before + linkBytesOf(level)) << "level " << k;
    (void)level.face();
    (void)level.outgoing();
    EXPECT_EQ(level.byteCount(), before + linkBytesOf(level)) << "level " << k;
  }
}

TEST(Links, EvaluationAndTrianglesDoWithout) {
  const Far::Refinement refinement = zipped(2);
  const std::int64_t before = refinement.byteCount();
  (void)levelPoints<float>(refinement, 2, torus(6, 5).points);
  (void)refinement.triangles(2);
  EXPECT_EQ(refinement.byteCount(), before);
}

TEST(Links, OfCopiesAreTheSameArrays) {
  const Far::Refinement refinement = zipped(1);
  const Far::Topology copy = refinement.last().topology;
  EXPECT_EQ(copy.twin().data(), refinement.last().topology.twin().data());
  EXPECT_EQ(copy.vert().data(), refinement.last().topology.vert().data());
}

TEST(Links, ComeAlongWithTheArrays) {
  const Far::Refinement refinement = zipped(2);
  const Far::Topology& level = refinement.last().topology;
  Far::TopologyArrays copied = level.arrays();
  EXPECT_EQ(copied.linkRule, nullptr);
  EXPECT_TRUE(std::equal(copied.twin.begin(), copied.twin.end(), level.twin().begin(), level.twin().end()));
  EXPECT_TRUE(std::equal(copied.face.begin(), copied.face.end(), level.face().begin(), level.face().end()));
  EXPECT_TRUE(
      std::equal(copied.outgoing.begin(), copied.outgoing.end(), level.outgoing().begin(), level.outgoing().end()));
  copied.vert[0] = -7;
  EXPECT_EQ(level.vert(0), 0) << "the arrays are a copy";

  Far::Topology alone = zipped(2).last().topology;
  const Far::TopologyArrays taken = std::move(alone).arrays();
  EXPECT_EQ(taken.linkRule, nullptr);
  EXPECT_TRUE(std::equal(taken.twin.begin(), taken.twin.end(), level.twin().begin(), level.twin().end()));
}

TEST(Links, AreNotNeededForTheNextStep) {
  const Far::Scheme scheme = schemeCase(NamedTension::paper).scheme;
  for (const PolyMesh& mesh : {torus(6, 5), prism(7), tetrahedron()}) {
    const Far::Refinement whole = refined(mesh, scheme, 3);
    // From a level of which only the arrays are known, by its links.
    const auto rest = Far::refine(Far::Topology(whole.level(1).topology.arrays()), scheme, 2);
    ASSERT_TRUE(rest.has_value());
    const auto expected = rest->last().topology.vert();
    const auto built = whole.last().topology.vert();
    EXPECT_TRUE(std::equal(built.begin(), built.end(), expected.begin(), expected.end()));
  }
}

TEST(SharedCorners, TablesOfWholeFacesReadTheLevelBefore) {
  const Far::Refinement refinement = zipped(2);
  for (std::int32_t k = 1; k <= 2; ++k) {
    const Far::Topology& before = refinement.level(k - 1).topology;
    EXPECT_EQ(refinement.level(k).table.indices.data(), before.vert().data());
    EXPECT_EQ(refinement.byteCount(k) + bytes(before.vert()),
              refinement.level(k).topology.byteCount() + refinement.level(k).table.byteCount());
  }
}

TEST(SharedCorners, AnEditedTableLeavesTheLevelAlone) {
  const Far::Refinement refinement = zipped(1);
  Far::LevelTable table = refinement.last().table;
  table.indices.edit()[0] = 17;
  EXPECT_EQ(table.indices[0], 17);
  EXPECT_EQ(refinement.last().table.indices[0], 0);
  const std::int32_t* own = table.indices.data();
  table.indices.edit()[1] = 18;
  EXPECT_EQ(table.indices.data(), own) << "alone, it is not copied again";
}

TEST(SharedCorners, OutliveTheRefinement) {
  const Far::LevelTable table = zipped(1).last().table;
  const Far::Topology control = toTopology(torus(6, 5));
  EXPECT_TRUE(std::equal(table.indices.begin(), table.indices.end(), control.vert().begin(), control.vert().end()));
}

}  // namespace
}  // namespace honeycomb::Test
