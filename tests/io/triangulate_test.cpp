#include "io/triangulate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace honeycomb::Io::Test {
namespace {

using Corners = std::vector<std::int32_t>;

/// One face of the given points, each x y z.
Corners cutFace(const std::vector<float>& points) {
  const auto sides = static_cast<std::int32_t>(points.size() / 3);
  Corners vertices;
  for (std::int32_t v = 0; v < sides; ++v) vertices.push_back(v);
  return triangulate(Corners{0, sides}, vertices, points);
}

/// Twice the signed area in x and y.
double area(const std::vector<float>& points, const std::int32_t* corners, std::size_t count) {
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto a = static_cast<std::size_t>(3 * corners[i]), b = static_cast<std::size_t>(3 * corners[(i + 1) % count]);
    sum += double{points[a]} * points[b + 1] - double{points[a + 1]} * points[b];
  }
  return sum;
}

/// All triangles turn the face's way, and together they are as large: they cover it once.
void expectCovered(const std::vector<float>& points) {
  const Corners corners = cutFace(points);
  ASSERT_EQ(corners.size(), points.size() - 6);
  Corners whole;
  for (std::size_t v = 0; 3 * v < points.size(); ++v) whole.push_back(static_cast<std::int32_t>(v));
  double sum = 0;
  for (std::size_t t = 0; t < corners.size(); t += 3) {
    const double one = area(points, corners.data() + t, 3);
    EXPECT_GT(one, 0) << "triangle " << t / 3;
    sum += one;
  }
  EXPECT_NEAR(sum, area(points, whole.data(), whole.size()), 1e-5);
}

std::vector<float> regular(int sides) {
  std::vector<float> points;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    for (const double x : {std::cos(angle), std::sin(angle), 0.0}) points.push_back(static_cast<float>(x));
  }
  return points;
}

TEST(Triangulate, ConvexFacesAreCoveredOnce) {
  for (const int sides : {3, 4, 5, 6, 7, 12, 100, 256, 257, 2000}) expectCovered(regular(sides));
}

TEST(Triangulate, ConcaveFacesAreCoveredOnce) {
  expectCovered({0, 0, 0, 2, 1, 0, 0, 2, 0, 0.5F, 1, 0});                          // an arrowhead
  expectCovered({0, 0, 0, 3, 0, 0, 3, 1, 0, 1, 1, 0, 1, 3, 0, 0, 3, 0});           // an L
  expectCovered({0, 0, 0, 4, 0, 0, 4, 3, 0, 3, 1, 0, 2, 3, 0, 1, 1, 0, 0, 3, 0});  // a W
}

TEST(Triangulate, AQuadIsCutAlongItsShorterDiagonal) {
  const std::vector<float> kite{0, 0, 0, 4, -1, 0, 8, 0, 0, 4, 1, 0};
  const Corners corners = cutFace(kite);
  for (std::ptrdiff_t t = 0; t < 6; t += 3)
    EXPECT_EQ(std::count(corners.begin() + t, corners.begin() + t + 3, 1) +
                  std::count(corners.begin() + t, corners.begin() + t + 3, 3),
              2);
}

TEST(Triangulate, FacesTurnedInSpaceAreCutAlike) {
  std::vector<float> lying = regular(6), standing;
  for (std::size_t i = 0; i < lying.size(); i += 3) standing.insert(standing.end(), {5, lying[i], lying[i + 1]});
  lying[0] = standing[1] = 1.5F;  // not quite regular: no two cuts are as long
  lying[4] = standing[5] = 1.2F;
  EXPECT_EQ(cutFace(standing), cutFace(lying));
}

TEST(Triangulate, CornersAreNumberedThroughAllFaces) {
  const std::vector<float> points{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  const Corners corners = triangulate(Corners{0, 3, 6}, Corners{0, 1, 2, 0, 2, 3}, points);
  EXPECT_EQ(corners, (Corners{0, 1, 2, 3, 4, 5}));
}

TEST(Triangulate, FacesWithoutAnAreaComeOutWhole) {
  EXPECT_EQ(cutFace(std::vector<float>(18, 1.0F)).size(), 12U);         // one point
  EXPECT_EQ(cutFace({0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0}).size(), 6U);  // a line
  EXPECT_EQ(cutFace({0, 0, 0, 1, 1, 0, 1, 0, 0, 0, 1, 0}).size(), 6U);  // a bow tie
}

}  // namespace
}  // namespace honeycomb::Io::Test
