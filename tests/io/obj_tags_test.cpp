#include "io/obj_tags.h"

#include <gmock/gmock.h>

#include <string>

#include "io/obj.h"
#include "tests/io/parse.h"

namespace honeycomb::Io::Test {
namespace {

using testing::ElementsAre;

/// Two quads side by side.
const std::string kStrip = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nf 1 2 5 4\nf 2 3 6 5\n";
std::vector<std::string> creases(const Mesh& mesh) {
  std::vector<std::string> lines;
  for (const Far::Crease& c : mesh.polygons.creases) {
    lines.push_back(std::to_string(c.vertex0) + "-" + std::to_string(c.vertex1) + " " + std::to_string(c.sharpness));
  }
  return lines;
}

TEST(ObjTags, CreaseHasTwoVerticesFromZeroAndASharpness) {
  const Mesh mesh = parsed(kStrip + "t crease 2/1/0 1 4 2.5\n");
  EXPECT_THAT(creases(mesh), ElementsAre("1-4 2.500000"));
  EXPECT_THAT(mesh.creaseLines, ElementsAre(9));
  EXPECT_TRUE(mesh.polygons.corners.empty());
}

TEST(ObjTags, CreaseMayNameManyEdgesWithOneSharpnessOrOneEach) {
  const Mesh mesh = parsed("t crease 4/1/0 0 1 1 2 3\nt crease 4/2/0 3 4 4 5 10 \\\n 0\n" + kStrip);
  EXPECT_THAT(creases(mesh), ElementsAre("0-1 3.000000", "1-2 3.000000", "3-4 10.000000", "4-5 0.000000"));
  EXPECT_THAT(mesh.creaseLines, ElementsAre(1, 1, 2, 2));
}

TEST(ObjTags, CornerHasAVertexFromZeroAndSharpnessTenOrMore) {
  const Mesh mesh = parsed(kStrip + "t corner 1/1/0 0 10\nt corner 2/1/0 2 5 12\n");
  EXPECT_EQ(mesh.polygons.corners, (Indices{0, 2, 5}));
  EXPECT_THAT(mesh.cornerLines, ElementsAre(9, 10, 10));
}

TEST(ObjTags, OthersArePassedOver) {
  const Mesh mesh = parsed(kStrip + "t interpolateboundary 1/0/0 1\nt\nt smoothtriangles 0/0/1 what ever\nf 1 4 5\n");
  EXPECT_TRUE(mesh.polygons.creases.empty());
  EXPECT_TRUE(mesh.polygons.corners.empty());
  EXPECT_EQ(mesh.polygons.faceCount(), 3);
}

TEST(ObjTags, CountsThatCannotBeRead) {
  const std::string rest = "a tag's counts can't be read; write t NAME integers/reals/strings, such as 2/1/0";
  for (const char* counts : {"", "2", "2/1", "2/1/", "2/1/x", "2/1/0x", "-2/1/0", "a/b/c"}) {
    EXPECT_EQ(message(kStrip + "t crease " + counts + "\n"), "mesh.obj:9: " + rest) << counts;
  }
}

TEST(ObjTags, NumbersThatCannotBeRead) {
  EXPECT_EQ(message(kStrip + "t crease 2/1/0 1 4.5 2\n"),
            "mesh.obj:9: a crease tag announces 2 vertex numbers, and number 2 can't be read; write whole numbers that "
            "count from 0");
  EXPECT_EQ(message(kStrip + "t crease 2/1/0 1\n"),
            "mesh.obj:9: a crease tag announces 2 vertex numbers, and number 2 can't be read; write whole numbers that "
            "count from 0");
  const std::string rest =
      "mesh.obj:9: a crease tag announces 1 sharpnesses, and number 1 can't be read; write numbers that aren't "
      "negative";
  for (const char* sharpness : {"", "-1", "sharp", "nan", "inf"}) {
    EXPECT_EQ(message(kStrip + "t crease 2/1/0 1 4 " + sharpness + "\n"), rest) << sharpness;
  }
  EXPECT_EQ(refusal(kStrip + "t crease 2/1/0 1 4 -1\n").element, 9);
}

TEST(ObjTags, CountsThatDoNotFit) {
  EXPECT_EQ(message(kStrip + "t crease 2/1/0 1 4 2 3\n"),
            "mesh.obj:9: a crease tag has 1 words behind its numbers and announces 0; correct its counts");
  for (const char* tag : {"3/1/0 1 4 2 9", "0/1/0 9", "2/0/0 1 4", "4/3/0 0 1 1 2 3 3 3"}) {
    EXPECT_NE(message(kStrip + "t crease " + tag + "\n").find("write t crease 2/1/0 a b sharpness, with two vertices"),
              std::string::npos)
        << tag;
  }
  EXPECT_EQ(message(kStrip + "t corner 3/2/0 0 2 5 10 10\n"),
            "mesh.obj:9: a corner tag has 3 vertex numbers and 2 sharpnesses; write t corner 1/1/0 v sharpness");
}

TEST(ObjTags, VerticesThatTheFileHasNot) {
  const std::string rest = " (counted from 0), but the file has 6 vertices; correct the number";
  EXPECT_EQ(message("t crease 2/1/0 1 6 2\n" + kStrip), "mesh.obj:1: a tag names vertex 6" + rest);
  EXPECT_EQ(message(kStrip + "t corner 1/1/0 -1 10\n"), "mesh.obj:9: a tag names vertex -1" + rest);
}

TEST(ObjTags, CornersThatAreNotSharpEnough) {
  EXPECT_EQ(message(kStrip + "t corner 2/2/0 0 2 10 9.5\n"),
            "mesh.obj:9: vertex 2 (counted from 0) can't be a corner of sharpness 9.5; corners are of sharpness 10 or "
            "more, on a boundary or a crease");
}

}  // namespace
}  // namespace honeycomb::Io::Test
