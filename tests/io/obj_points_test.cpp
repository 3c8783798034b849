#include "io/obj_points.h"

#include <gmock/gmock.h>

namespace honeycomb::Test {
namespace {

TEST(ObjPoints, TakesTheVStatementsAndPassesOverTheRest) {
  const auto points =
      Io::parseObjPoints("# c\nv 1 2 3\r\nvn 0 0 1\nv -1 1e-3 \\\n 5 0.5\nf 1 2 1\nusemtl a\nv 0 0 0 1 1 1", "p.obj");
  ASSERT_TRUE(points);
  EXPECT_THAT(points->positions, testing::ElementsAre(1, 2, 3, -1, 1e-3, 5, 0, 0, 0));
  EXPECT_THAT(points->lines, testing::ElementsAre(2, 4, 8));
}

TEST(ObjPoints, RefusesWhatIsNoPointWithItsLine) {
  const auto message = [](std::string_view text) {
    const auto points = Io::parseObjPoints(text, "p.obj");
    return points ? std::string() : points.error().message;
  };
  EXPECT_EQ(message("v 0 0 0\nv 1 x 0\n"),
            "p.obj:2: a coordinate is not a number; write a decimal number such as -0.5 or 1e-3");
  EXPECT_EQ(message("\nv 1 2\n"), "p.obj:2: a point has 2 numbers; write v x y z");
  EXPECT_EQ(message("v 0 0 0\nv 0 inf 0\n"),
            "p.obj:2: point 2 (counted from 1) has the coordinate inf; give it a finite position");
  EXPECT_EQ(message("f 1 2 3\n"),
            "p.obj: has no points ('v' statements); give a Wavefront OBJ file with v x y z lines");
  EXPECT_EQ(message(std::string_view("v 0 0 0\n\0", 9)),
            "p.obj: holds NUL bytes and so is no text; give a Wavefront OBJ file in ASCII or UTF-8");
}

TEST(ObjPoints, RefusesFilesThatAreNotThere) {
  const auto points = Io::readObjPoints("/nonexistent/p.obj");
  ASSERT_FALSE(points);
  EXPECT_EQ(points.error().code, ErrorCode::unreadable);
}

}  // namespace
}  // namespace honeycomb::Test
