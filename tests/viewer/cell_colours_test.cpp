#include "apps/viewer/cell_colours.h"

#include <gtest/gtest.h>

#include <set>

#include "far/schemes/akleman.h"
#include "tests/viewer/cube.h"

namespace honeycomb::ViewerTests {
namespace {

/// 0xAABBGGRR of 0xRRGGBB.
std::uint32_t opaque(Viewer::Rgb colour) {
  return 0xff000000U | ((colour.value & 255U) << 16U) | (colour.value & 0xff00U) | (colour.value >> 16U);
}

TEST(CellColours, FollowSideCountsAndOrigins) {
  const auto control = Far::Topology::create(Cube(0).polygons());
  ASSERT_TRUE(control) << control.error().message;
  const auto refinement = Far::refine(*control, *Far::akleman(), 2);
  ASSERT_TRUE(refinement) << refinement.error().message;
  const Viewer::Palette palette;
  for (const std::uint32_t colour : Viewer::cellColours(*refinement, 0)) EXPECT_EQ(colour, opaque(palette.quad));

  const std::vector<std::uint32_t> colours = Viewer::cellColours(*refinement, 2);
  const Far::Topology& topology = refinement->level(2).topology;
  ASSERT_EQ(colours.size(), static_cast<std::size_t>(topology.faceCount()));
  const std::vector<Far::Origin> origins = refinement->faceOrigins(2);
  std::set<std::uint32_t> onFaces;
  std::set<std::uint32_t> roundVertices;
  for (std::int32_t f = 0; f < topology.faceCount(); ++f) {
    const auto i = static_cast<std::size_t>(f);
    if (topology.sides(f) == 4) {
      EXPECT_EQ(colours[i], opaque(palette.quad)) << "face " << f;
    }
    if (topology.sides(f) == 6) (origins[i].vertex ? roundVertices : onFaces).insert(colours[i]);
  }
  EXPECT_EQ(onFaces.size(), 1U) << "all control faces are quads";
  EXPECT_EQ(roundVertices.size(), 1U);
  EXPECT_NE(onFaces, roundVertices);
  EXPECT_EQ(onFaces.count(opaque(palette.quad)), 0U) << "hexagons stay apart from the quads they descend from";
}

}  // namespace
}  // namespace honeycomb::ViewerTests
