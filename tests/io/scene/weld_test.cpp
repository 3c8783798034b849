#include "io/scene/weld.h"

#include <gmock/gmock.h>

#include <vector>

#include "tests/support/random.h"

namespace honeycomb::Io::Test {
namespace {

using testing::ElementsAre;

/// Vertices on a line, each moved by the joints given.
struct OnALine {
  double x;
  std::vector<Influence> influences;
  std::vector<MorphOffset> morphs = {};
};

Skin skinOf(const std::vector<OnALine>& vertices) {
  Skin skin;
  for (const OnALine& vertex : vertices) {
    skin.positions.insert(skin.positions.end(), {vertex.x, 0, 0});
    skin.influences.insert(skin.influences.end(), vertex.influences.begin(), vertex.influences.end());
    skin.influenceOffsets.push_back(std::ssize(skin.influences));
    skin.morphs.insert(skin.morphs.end(), vertex.morphs.begin(), vertex.morphs.end());
    skin.morphOffsets.push_back(std::ssize(skin.morphs));
  }
  return skin;
}

TEST(WeldVertices, TheSamePlaceIsOneVertex) {
  const std::vector<Influence> one{{0, 1}};
  const Weld weld = weldVertices(skinOf({{0, one}, {1, one}, {-0.0, one}, {1, one}, {1.001, one}}), 0);
  EXPECT_THAT(weld.representative, ElementsAre(0, 1, 0, 1, 4));
  EXPECT_EQ(weld.disagreeing, 0);
}

TEST(WeldVertices, ToleranceReachesAcrossCells) {
  const std::vector<Influence> one{{0, 1}};
  for (double at = -0.5; at < 0.5; at += 0.0137) {
    const Weld weld = weldVertices(skinOf({{at, one}, {at + 0.099, one}, {at - 0.099, one}, {at + 0.101, one}}), 0.1);
    EXPECT_THAT(weld.representative, ElementsAre(0, 0, 0, 3)) << at;
  }
}

TEST(WeldVertices, WhatMovesDifferentlyStaysApart) {
  const std::vector<Influence> one{{0, 1}}, other{{1, 1}}, mixed{{0, 0.5}, {1, 0.5}},
      nearly{{0, 0.50005}, {1, 0.49995}};
  const Weld weld = weldVertices(skinOf({{0, one}, {0, other}, {0, mixed}, {0, nearly}, {0, other}}), 0.1);
  EXPECT_THAT(weld.representative, ElementsAre(0, 1, 2, 2, 1));
  EXPECT_EQ(weld.disagreeing, 2);
}

TEST(WeldVertices, MorphTargetsHaveToAgree) {
  const std::vector<Influence> one{{0, 1}};
  const Weld weld = weldVertices(
      skinOf({{0, one, {{0, {1, 0, 0}}}}, {0, one}, {0, one, {{0, {1.01, 0, 0}}}}, {0, one, {{1, {1, 0, 0}}}}}), 0.1);
  EXPECT_THAT(weld.representative, ElementsAre(0, 1, 0, 3));
}

// Against comparing every pair.
TEST(WeldVertices, RandomPointsAgreeWithTheSlowWay) {
  honeycomb::Test::Random random(3);
  std::vector<OnALine> vertices;
  for (int i = 0; i < 400; ++i)
    vertices.push_back({random.symmetric(), {{static_cast<std::int32_t>(random.below(2)), 1}}});
  const Weld weld = weldVertices(skinOf(vertices), 0.004);
  std::vector<std::int32_t> slow;
  for (std::int32_t v = 0; v < 400; ++v) {
    slow.push_back(v);
    for (std::int32_t u = 0; u < v; ++u) {
      const OnALine& a = vertices[static_cast<std::size_t>(u)];
      const OnALine& b = vertices[static_cast<std::size_t>(v)];
      if (slow[static_cast<std::size_t>(u)] != u || a.influences != b.influences || std::abs(a.x - b.x) > 0.004)
        continue;
      slow.back() = u;
      break;
    }
  }
  EXPECT_EQ(weld.representative, slow);
}

}  // namespace
}  // namespace honeycomb::Io::Test
