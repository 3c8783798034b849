#include "apps/viewer/look.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "far/schemes/akleman.h"
#include "tests/viewer/cube.h"

namespace honeycomb::Test {
namespace {

/// Two quads side by side.
Far::Topology twoQuads() {
  Far::Polygons polygons;
  polygons.vertexCount = 6;
  polygons.addFace({0, 1, 4, 3});
  polygons.addFace({1, 2, 5, 4});
  return Far::Topology::create(polygons).value();
}

std::vector<float> flatPoints() {
  return {0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0};
}

TEST(FlatnessTest, FlatCellsHaveNone) {
  EXPECT_NEAR(Viewer::flatness(twoQuads(), flatPoints()).most, 0, 1e-7);
}

TEST(FlatnessTest, IsTheDistanceFromThePlaneOverTheDiameter) {
  std::vector<float> points = flatPoints();
  // The second quad becomes a saddle of +-h about its plane: corners h away, the farthest sqrt(1/2 + h^2) from the
  // middle.
  const float h = 0.1F;
  points[3 * 1 + 2] = points[3 * 5 + 2] = h;
  points[3 * 2 + 2] = points[3 * 4 + 2] = -h;
  const Viewer::Bend bend = Viewer::flatness(twoQuads(), points);
  EXPECT_NEAR(bend.most, h / (2 * std::sqrt(0.5F + h * h)), 1e-5);
  EXPECT_EQ(bend.face, 1);
}

TEST(FlatnessTest, DoesNotDependOnSize) {
  std::vector<float> points = flatPoints();
  points[2] = 0.3F;
  const float bend = Viewer::flatness(twoQuads(), points).most;
  for (float& number : points) number *= 1000;
  EXPECT_NEAR(Viewer::flatness(twoQuads(), points).most, bend, 1e-5);
}

TEST(RingsTest, CountTheFacesToTheNextThatIsNoHexagon) {
  const auto control = Far::Topology::create(ViewerTests::Cube(0).polygons());
  const auto refinement = Far::refine(control.value(), Far::akleman().value(), 3);
  const Far::Topology& topology = refinement->last().topology;
  const std::vector<std::int32_t> rings = Viewer::ringsFromExtraordinary(topology, 4);
  std::int32_t farthest = 0;
  for (std::int32_t f = 0; f < topology.faceCount(); ++f) {
    EXPECT_EQ(rings[static_cast<std::size_t>(f)] == 0, topology.sides(f) != 6) << f;
    std::int32_t least = 4;
    for (const std::int32_t h : topology.halfEdgesOf(f))
      least = std::min(least, 1 + rings[static_cast<std::size_t>(topology.face(topology.twin(h)))]);
    if (topology.sides(f) == 6) {
      EXPECT_EQ(rings[static_cast<std::size_t>(f)], least) << f;
    }
    farthest = std::max(farthest, rings[static_cast<std::size_t>(f)]);
  }
  EXPECT_GT(farthest, 1);
}

TEST(LooksTest, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const Viewer::Look& look : Viewer::looks()) names.insert(look.name);
  EXPECT_EQ(names.size(), Viewer::looks().size());
}

}  // namespace
}  // namespace honeycomb::Test
