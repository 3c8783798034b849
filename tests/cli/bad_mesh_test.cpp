#include "workplace.h"

namespace honeycomb::Test {
namespace {

using testing::HasSubstr;

/// A mesh that must be refused, and what the one line must say.
struct BadMesh {
  std::string name;
  std::string obj;
  std::string line;  ///< ":LINE:" behind the file, or ":" where no line is to blame
  std::string what;
  int defects = 0;  ///< that `honeycomb info` lists; 0: the file itself can't be read
};

void PrintTo(const BadMesh& mesh, std::ostream* out) {
  *out << mesh.name;
}

class BadMeshTest : public Workplace, public testing::WithParamInterface<BadMesh> {};

TEST_P(BadMeshTest, IsRefusedByEveryCommandWithItsPlace) {
  const std::string in = file("bad.obj", GetParam().obj);
  const auto place = HasSubstr(in + GetParam().line), what = HasSubstr(GetParam().what);
  EXPECT_REFUSED((std::vector<std::string>{"refine", in, path("out.obj")}), place, what);
  EXPECT_REFUSED((std::vector<std::string>{"convert", in, path("out.obj"), "--to", "dual"}), place, what);
  const std::string frames = cache("in.pc2", 8, 1, std::vector<float>(24, 1.0F));
  EXPECT_REFUSED((std::vector<std::string>{"bake", in, path("out.pc2"), "--cache", frames}), place, what);
}

TEST_P(BadMeshTest, IsListedByInfo) {
  const std::string in = file("bad.obj", GetParam().obj);
  const Outcome outcome = run({"info", in});
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_TRUE(isOneErrorLine(outcome.err)) << outcome.err;
  int listed = 0;
  for (std::size_t at = outcome.out.find(in + ":"); at != std::string::npos; at = outcome.out.find(in + ":", at + 1))
    ++listed;
  EXPECT_EQ(listed, GetParam().defects) << outcome.out;
}

/// The cube with a line more, which is line 15.
std::string cubeAnd(const std::string& lines) {
  return cubeObj() + lines;
}

const std::string kBowTie =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\n"
    "f 1 2 3\nf 1 4 5\n";
const std::string kFin = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n";
const std::string kOpposed = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nf 1 2 3\nf 1 2 4\n";

INSTANTIATE_TEST_SUITE_P(
    Bad, BadMeshTest,
    testing::Values(BadMesh{"IndexOutOfRange", cubeAnd("f 1 2 99\n"), ":15:", "99"},
                    BadMesh{"NegativeIndexOutOfRange", cubeAnd("f 1 2 -9\n"), ":15:", "-9"},
                    BadMesh{"ZeroIndex", cubeAnd("f 1 0 2\n"), ":15:", "0"},
                    BadMesh{"TwoSides", cubeAnd("f 1 2\n"), ":15:", "three"},
                    BadMesh{"VertexTwiceInAFace", cubeAnd("f 1 2 3 2\n"), ":15:", "face 7 has vertex 2 twice", 1},
                    BadMesh{"ThreeFacesOnAnEdge", kFin, ":8:", "face 3 is the third on the edge between vertices", 1},
                    BadMesh{"OppositeWindings", kOpposed, ":6:", "in the same direction as face 1", 1},
                    BadMesh{"BowTie", kBowTie, ":1:", "the faces at vertex 1 form more than one fan", 1},
                    BadMesh{"IsolatedVertices", cubeAnd("v 5 5 5\nv 6 6 6\n"), ":15:", "vertex 9 is in no face", 2},
                    BadMesh{"EmptyFile", "", ":", "empty"},
                    BadMesh{"BinaryGarbage",
                            std::string("\x7f"
                                        "ELF\0\1\2\3\0\0",
                                        10),
                            ":", "OBJ"},
                    BadMesh{"NoFaces", "v 0 0 0\n", ":", "no faces"},
                    BadMesh{"NotANumber", "v 0 zero 0\nf 1 1 1\n", ":1:", "zero"},
                    BadMesh{"NaN", "v 0 0 0\nv 0 nan 0\nv 1 0 0\nf 1 2 3\n", ":2:", "vertex 2 (counted from 1)"},
                    BadMesh{"Infinity", "v 0 0 0\nv 1 0 0\nv 0 0 -inf\nf 1 2 3\n", ":3:", "vertex 3 (counted from 1)"}),
    [](const auto& tested) { return tested.param.name; });

class MeshTest : public Workplace {};

TEST_F(MeshTest, OneLineGivesTheFirstDefectTheCountAndWhereAllAreListed) {
  const std::string in = file("bad.obj", cubeAnd("v 5 5 5\nv 6 6 6\n"));
  EXPECT_REFUSED((std::vector<std::string>{"refine", in, path("out.obj")}), HasSubstr("vertex 9 "),
                 HasSubstr("of 2 defects"), HasSubstr("honeycomb info " + in), HasSubstr("count from 1"),
                 HasSubstr("--drop-isolated"));
}

TEST_F(MeshTest, MissingFileIsNamed) {
  EXPECT_REFUSED((std::vector<std::string>{"refine", path("none.obj"), path("out.obj")}), HasSubstr(path("none.obj")));
}

TEST_F(MeshTest, ThreeGigabytesOfNothingAreRefusedWithoutReadingThem) {
  constexpr std::uintmax_t kSize = std::uintmax_t{3} << 30;
  for (const std::string format : {"obj", "ply", "gltf", "glb", "fbx"}) {
    const std::string in = file("huge." + format, "");
    std::filesystem::resize_file(in, kSize);
    const Outcome outcome = run({"info", in});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_TRUE(isOneErrorLine(outcome.err)) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(in + ":"));
    EXPECT_LT(outcome.mostMemory, std::int64_t{1} << 30) << format;
  }
}

TEST_F(MeshTest, UnknownFormatIsRefusedWithAList) {
  const std::string in = file("cube.abc", "Ogawa");
  EXPECT_REFUSED((std::vector<std::string>{"refine", in, path("out.obj")}), HasSubstr(in),
                 HasSubstr(".obj, .ply, .gltf"));
  EXPECT_REFUSED((std::vector<std::string>{"refine", file("c.obj", cubeObj()), path("out.stl")}), HasSubstr("out.stl"),
                 HasSubstr(".obj"));
}

TEST_F(MeshTest, CoordinatePastSinglePrecisionNeedsDouble) {
  std::string huge = cubeObj();
  huge.replace(0, 7, "v 1e39 0 0");
  const std::string in = file("huge.obj", huge);
  EXPECT_REFUSED((std::vector<std::string>{"refine", in, path("out.obj")}), HasSubstr(in + ":1:"),
                 HasSubstr("vertex 1 "), HasSubstr("--precision double"));
  EXPECT_EQ(run({"refine", in, path("out.obj"), "--precision", "double"}).exitCode, 0);
}

TEST_F(MeshTest, RefinedCoordinatePastSinglePrecisionIsRefused) {
  std::string large;
  for (const std::string v : {"3e38 0 0", "3e38 1 0", "3e38 1 1", "3e38 0 1"}) large += "v " + v + "\n";
  const std::string in = file("large.obj", large + "f 1 2 3 4\n");
  EXPECT_REFUSED((std::vector<std::string>{"refine", in, path("out.obj"), "--levels", "1"}), HasSubstr(in),
                 HasSubstr("overflows single precision"));
}

TEST_F(MeshTest, DroppingIsolatedVerticesGivesTheMeshWithoutThem) {
  const std::string clean = file("clean.obj", cubeObj());
  const std::string in = file(
      "isolated.obj", "v 9 9 9\n" + [] {
        std::string shifted = cubeObj().substr(0, cubeObj().find('f'));
        return shifted + "v 8 8 8\nf 2 5 4 3\nf 6 7 8 9\nf 2 3 7 6\nf 3 4 8 7\nf 4 5 9 8\nf 5 2 6 9\n";
      }());
  ASSERT_EQ(run({"refine", clean, path("clean_out.obj")}).exitCode, 0);
  const Outcome outcome = run({"refine", in, path("out.obj"), "--drop-isolated"});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_EQ(read("out.obj"), read("clean_out.obj"));
}

TEST_F(MeshTest, NumbersInMessagesAreTheFilesEvenWhereVerticesWereDropped) {
  const std::string in = file("bad.obj", "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 2 3 4\nf 3 2 3 4\n");
  EXPECT_REFUSED((std::vector<std::string>{"refine", in, path("out.obj"), "--drop-isolated"}),
                 HasSubstr(in + ":6: face 2 has vertex 3 twice"));
}

}  // namespace
}  // namespace honeycomb::Test
