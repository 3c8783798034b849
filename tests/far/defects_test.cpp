#include "far/topology/defects.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/manifold_check.h"
#include "tests/support/random_mesh.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

using Far::DefectKind;
using testing::AllOf;
using testing::HasSubstr;

Far::Polygons polygons(std::int32_t vertexCount, const std::vector<std::vector<std::int32_t>>& faces) {
  Far::Polygons result;
  result.vertexCount = vertexCount;
  for (const auto& loop : faces) result.addFace(loop);
  return result;
}

std::string listed(const std::vector<Far::Defect>& defects) {
  std::string text;
  for (const Far::Defect& d : defects) text += Far::describe(d) + "\n";
  return text;
}

/// The mesh has exactly one defect; create() refuses it with its description, remedy and element.
Far::Defect onlyDefect(const Far::Polygons& mesh, DefectKind kind) {
  const auto defects = Far::findDefects(mesh);
  EXPECT_EQ(defects.size(), 1U) << listed(defects);
  if (defects.empty()) return {kind};
  EXPECT_EQ(defects[0].kind, kind) << listed(defects);
  const auto topology = Far::Topology::create(mesh);
  EXPECT_FALSE(topology.has_value());
  if (topology) return defects[0];
  EXPECT_EQ(topology.error().code, ErrorCode::invalidMesh);
  EXPECT_THAT(topology.error().message, AllOf(HasSubstr(Far::describe(defects[0])), HasSubstr(Far::remedy(kind))));
  EXPECT_EQ(topology.error().message.find('\n'), std::string::npos) << "one line";
  const std::int64_t element = defects[0].face >= 0 ? defects[0].face : defects[0].vertex;
  EXPECT_EQ(topology.error().element, element);
  EXPECT_EQ(topology.error().kind, defects[0].face >= 0 ? ElementKind::face : ElementKind::vertex);
  return defects[0];
}

TEST(Defects, NoneInSoundMeshes) {
  for (std::uint64_t seed = 0; seed < meshes(200); ++seed) {
    const RandomMesh random = randomMesh(seed);
    const auto defects = Far::findDefects(toPolygons(random.mesh, random.cornerTags));
    EXPECT_TRUE(defects.empty()) << "seed " << seed << ": " << listed(defects);
  }
}

TEST(Defects, IndexOutOfRange) {
  for (const std::int32_t index : {5, -1, 2147483647}) {
    const Far::Defect d =
        onlyDefect(polygons(5, {{0, 1, 2}, {0, 2, 3, 4}, {1, 0, index}}), DefectKind::indexOutOfRange);
    EXPECT_EQ(d.face, 2);
    EXPECT_EQ(d.vertex, index);
    EXPECT_THAT(Far::describe(d), AllOf(HasSubstr("face 2"), HasSubstr(std::to_string(index))));
  }
}

TEST(Defects, TooFewSides) {
  const Far::Defect d = onlyDefect(polygons(4, {{0, 1, 2}, {0, 2, 3}, {0, 1}}), DefectKind::tooFewSides);
  EXPECT_EQ(d.face, 2);
  EXPECT_THAT(Far::describe(d), HasSubstr("face 2"));
  EXPECT_EQ(onlyDefect(polygons(3, {{}, {0, 1, 2}}), DefectKind::tooFewSides).face, 0);
}

TEST(Defects, VertexTwiceInAFace) {
  const Far::Defect d = onlyDefect(polygons(5, {{0, 1, 2}, {0, 2, 3, 4, 3}}), DefectKind::repeatedVertex);
  EXPECT_EQ(d.face, 1);
  EXPECT_EQ(d.vertex, 3);
  EXPECT_THAT(Far::describe(d), AllOf(HasSubstr("face 1"), HasSubstr("vertex 3")));
}

TEST(Defects, ThreeFacesOnAnEdge) {
  const Far::Defect d = onlyDefect(polygons(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}), DefectKind::edgeOverused);
  EXPECT_EQ(d.face, 2);
  EXPECT_EQ(std::minmax({d.vertex, d.vertex2}), (std::pair<std::int64_t, std::int64_t>{0, 1}));
  EXPECT_EQ(d.otherFace, 0);
  EXPECT_THAT(Far::describe(d), AllOf(HasSubstr("0"), HasSubstr("1"), HasSubstr("face 2")));
}

TEST(Defects, OppositeWindings) {
  const Far::Defect d = onlyDefect(polygons(4, {{0, 1, 2}, {0, 1, 3}}), DefectKind::opposedFaces);
  EXPECT_EQ(d.face, 1);
  EXPECT_EQ(d.otherFace, 0);
  EXPECT_EQ(std::minmax({d.vertex, d.vertex2}), (std::pair<std::int64_t, std::int64_t>{0, 1}));
}

TEST(Defects, BowTieOfTwoFansOnTheBoundary) {
  const Far::Defect d = onlyDefect(polygons(5, {{0, 1, 2}, {0, 3, 4}}), DefectKind::bowTie);
  EXPECT_EQ(d.vertex, 0);
  EXPECT_THAT(Far::describe(d), HasSubstr("vertex 0"));
}

TEST(Defects, BowTieOfTwoClosedFans) {
  // Two tetrahedra that share vertex 3.
  Far::Polygons mesh =
      polygons(7, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}, {4, 5, 6}, {4, 3, 5}, {4, 6, 3}, {5, 3, 6}});
  EXPECT_EQ(onlyDefect(mesh, DefectKind::bowTie).vertex, 3);
}

TEST(Defects, BowTieOfAClosedAndAnOpenFan) {
  const Far::Polygons mesh = polygons(6, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}, {3, 4, 5}});
  EXPECT_EQ(onlyDefect(mesh, DefectKind::bowTie).vertex, 3);
}

TEST(Defects, IsolatedVertex) {
  const Far::Defect d = onlyDefect(polygons(5, {{0, 1, 2}, {0, 2, 4}}), DefectKind::isolatedVertex);
  EXPECT_EQ(d.vertex, 3);
  EXPECT_THAT(Far::describe(d), HasSubstr("vertex 3"));
}

TEST(Defects, CornerTagInsideTheMesh) {
  Far::Polygons mesh = toPolygons(grid(2, 2), {0, 4});
  EXPECT_EQ(onlyDefect(mesh, DefectKind::cornerNotOnBoundary).vertex, 4);
}

TEST(Defects, CornerTagsMayLieOnCreases) {
  Far::Polygons mesh = toPolygons(grid(2, 2), {4});
  mesh.creases = {{4, 5, 2}};
  EXPECT_TRUE(Far::findDefects(mesh).empty());
  mesh.creases = {{4, 5, 0}};
  EXPECT_EQ(onlyDefect(mesh, DefectKind::cornerNotOnBoundary).vertex, 4);
}

TEST(Defects, CornerTagOutOfRangeIsRefused) {
  for (const std::int32_t tag : {9, -1}) {
    Far::Polygons mesh = toPolygons(grid(2, 2));
    mesh.corners = {tag};
    EXPECT_FALSE(Far::Topology::create(mesh).has_value()) << tag;
  }
}

TEST(Defects, AreAllListedAndCounted) {
  Far::Polygons mesh = toPolygons(grid(3, 3));
  mesh.vertexCount = 30;
  mesh.addFace({16, 17, 99});      // out of range
  mesh.addFace({17, 18});          // too few sides
  mesh.addFace({18, 19, 20, 19});  // a vertex twice
  mesh.addFace({21, 22, 23});      // a sound island
  mesh.addFace({21, 22, 24});      // wound against it
  const auto defects = Far::findDefects(mesh);
  const auto count = [&defects](DefectKind kind) {
    return std::count_if(defects.begin(), defects.end(), [kind](const Far::Defect& d) { return d.kind == kind; });
  };
  EXPECT_EQ(count(DefectKind::indexOutOfRange), 1) << listed(defects);
  EXPECT_EQ(count(DefectKind::tooFewSides), 1) << listed(defects);
  EXPECT_EQ(count(DefectKind::repeatedVertex), 1) << listed(defects);
  EXPECT_EQ(count(DefectKind::opposedFaces), 1) << listed(defects);
  EXPECT_EQ(count(DefectKind::isolatedVertex), 5) << "vertices 25 to 29\n" << listed(defects);
  EXPECT_TRUE(std::is_sorted(defects.begin(), defects.end(), [](const Far::Defect& a, const Far::Defect& b) {
    return a.kind < b.kind;
  })) << "ordered by kind";
  const auto topology = Far::Topology::create(mesh);
  ASSERT_FALSE(topology.has_value());
  EXPECT_THAT(topology.error().message,
              AllOf(HasSubstr(Far::describe(defects[0])), HasSubstr(std::to_string(defects.size()))));
}

TEST(Defects, EveryKindHasARemedy) {
  for (int kind = 0; kind <= static_cast<int>(DefectKind::creaseWithoutEdge); ++kind) {
    EXPECT_FALSE(Far::remedy(static_cast<DefectKind>(kind)).empty()) << kind;
  }
}

/// Random damage: whatever the tests' own checker refuses must be refused, and the other way round.
TEST(Defects, AgreeWithTheTestsOwnCheckerOnDamagedMeshes) {
  std::uint64_t refused = 0;
  for (std::uint64_t seed = 0; seed < meshes(400); ++seed) {
    RandomMesh random = randomMesh(seed);
    Random choice(seed);
    Loop& loop = random.mesh.faces[choice.below(random.mesh.faces.size())];
    switch (choice.below(4)) {
      case 0:
        std::reverse(loop.begin(), loop.end());
        break;
      case 1:
        loop[choice.below(loop.size())] = choice.below(random.mesh.points.size());
        break;
      case 2:
        random.mesh.faces.push_back(loop);
        break;
      default:
        std::swap(loop[0], loop[choice.below(loop.size())]);
        break;
    }
    std::vector<bool> used(random.mesh.points.size(), false);
    for (const Loop& face : random.mesh.faces) {
      for (const std::size_t v : face) used[v] = true;
    }
    const bool sound = isManifold(random.mesh.faces) && std::find(used.begin(), used.end(), false) == used.end();
    const auto defects = Far::findDefects(toPolygons(random.mesh));
    EXPECT_EQ(defects.empty(), sound) << "seed " << seed << "\n" << listed(defects);
    EXPECT_EQ(Far::Topology::create(toPolygons(random.mesh)).has_value(), sound) << "seed " << seed;
    refused += sound ? 0U : 1U;
  }
  EXPECT_GT(refused, meshes(400) / 2);
}

}  // namespace
}  // namespace honeycomb::Test
