#include "far/conversions/split_non_manifold.h"

#include <gmock/gmock.h>

#include <set>
#include <string>
#include <vector>

#include "far/topology/defects.h"
#include "tests/support/manifold_check.h"
#include "tests/support/random.h"

namespace honeycomb::Test {
namespace {

using testing::ElementsAre;
using Face = std::vector<std::int32_t>;

Far::Polygons toSplit(std::int32_t vertexCount, const std::vector<Face>& faces) {
  Far::Polygons result;
  result.vertexCount = vertexCount;
  for (const Face& loop : faces) result.addFace(loop);
  return result;
}

std::vector<Face> facesOf(const Far::Polygons& polygons) {
  std::vector<Face> faces;
  for (std::size_t f = 0; f + 1 < polygons.faceOffsets.size(); ++f)
    faces.emplace_back(polygons.indices.begin() + polygons.faceOffsets[f],
                       polygons.indices.begin() + polygons.faceOffsets[f + 1]);
  return faces;
}

std::string whyNoManifold(const Far::Polygons& polygons) {
  std::vector<Loop> loops;
  for (const Face& face : facesOf(polygons)) loops.emplace_back(face.begin(), face.end());
  std::string why;
  return isManifold(loops, &why) ? "" : "no manifold: " + why;
}

TEST(SplitNonManifold, AManifoldComesBackAsItIs) {
  const Far::Polygons tetrahedron = toSplit(4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  const Far::ManifoldSplit split = Far::splitNonManifold(tetrahedron);
  EXPECT_EQ(split.polygons.indices, tetrahedron.indices);
  EXPECT_EQ(split.duplicates(4), 0);
  EXPECT_EQ(split.edgesCut, 0);
}

TEST(SplitNonManifold, ThirdFaceOnAnEdgeIsCutOff) {
  const Far::ManifoldSplit split = Far::splitNonManifold(toSplit(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}));
  EXPECT_EQ(split.edgesCut, 1);
  EXPECT_EQ(split.duplicates(5), 4);
  EXPECT_THAT(facesOf(split.polygons), ElementsAre(Face{0, 1, 2}, Face{5, 6, 3}, Face{7, 8, 4}));
  EXPECT_THAT(split.sourceVertices, ElementsAre(0, 1, 2, 3, 4, 1, 0, 0, 1));
}

TEST(SplitNonManifold, FacesThatRunTheSameWayAlongAnEdgePart) {
  const Far::ManifoldSplit split = Far::splitNonManifold(toSplit(4, {{0, 1, 2}, {0, 1, 3}}));
  EXPECT_EQ(split.edgesCut, 1);
  EXPECT_EQ(whyNoManifold(split.polygons), "");
  EXPECT_EQ(split.duplicates(4), 2);
}

TEST(SplitNonManifold, ABowTieBecomesTwoVertices) {
  const Far::ManifoldSplit split = Far::splitNonManifold(toSplit(5, {{0, 1, 2}, {0, 3, 4}}));
  EXPECT_EQ(split.bowTies, 1);
  EXPECT_EQ(split.edgesCut, 0);
  EXPECT_THAT(facesOf(split.polygons), ElementsAre(Face{0, 1, 2}, Face{5, 3, 4}));
}

TEST(SplitNonManifold, WhatIsNoFaceIsLeftOut) {
  const Far::ManifoldSplit split =
      Far::splitNonManifold(toSplit(4, {{0, 1}, {0, 1, 2}, {1, 1, 2}, {0, 9, 2}, {2, 1, 3}}));
  EXPECT_EQ(split.facesLeftOut, 3);
  EXPECT_THAT(split.sourceFaces, ElementsAre(1, 4));
  EXPECT_EQ(split.duplicates(4), 0);
}

TEST(SplitNonManifold, TagsFollowTheirVerticesAndEdges) {
  Far::Polygons fan = toSplit(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  fan.corners = {0};
  fan.creases = {{1, 0, 3.0}, {1, 2, 2.0}};
  const Far::ManifoldSplit split = Far::splitNonManifold(fan);
  EXPECT_THAT(split.polygons.corners, ElementsAre(0, 6, 7));
  std::vector<std::string> creases;
  for (const Far::Crease& c : split.polygons.creases)
    creases.push_back(std::to_string(c.vertex0) + "-" + std::to_string(c.vertex1) + ":" +
                      std::to_string(static_cast<int>(c.sharpness)));
  EXPECT_THAT(creases, ElementsAre("0-1:3", "1-2:2", "5-6:3", "7-8:3"));
}

// Triangles between few vertices at random: nearly every edge has too many faces.
TEST(SplitNonManifold, AnyTrianglesBecomeAManifoldThatKeepsThemAll) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    const std::size_t vertices = random.between(3, 12), count = random.between(1, 40);
    std::vector<Face> faces;
    while (faces.size() < count) {
      const Face face{static_cast<std::int32_t>(random.below(vertices)),
                      static_cast<std::int32_t>(random.below(vertices)),
                      static_cast<std::int32_t>(random.below(vertices))};
      if (std::set<std::int32_t>(face.begin(), face.end()).size() == 3) faces.push_back(face);
    }
    const Far::ManifoldSplit split = Far::splitNonManifold(toSplit(static_cast<std::int32_t>(vertices), faces));
    EXPECT_EQ(whyNoManifold(split.polygons), "") << seed;
    std::vector<Face> back = facesOf(split.polygons);
    for (Face& face : back)
      for (std::int32_t& v : face) v = split.sourceVertices[static_cast<std::size_t>(v)];
    EXPECT_EQ(back, faces) << seed;
  }
}

}  // namespace
}  // namespace honeycomb::Test
