#include <string>

#include "io/obj.h"
#include "tests/io/files.h"
#include "tests/io/parse.h"

namespace honeycomb::Io::Test {
namespace {

using namespace std::string_view_literals;

TEST(ObjErrors, EmptyFile) {
  EXPECT_EQ(message(""), "mesh.obj: is empty; give a Wavefront OBJ file");
  EXPECT_EQ(refusal("").code, ErrorCode::invalidFile);
  EXPECT_EQ(refusal("").element, -1);
}

TEST(ObjErrors, NoVertices) {
  const std::string expected = "mesh.obj: has no vertices ('v' statements); give a Wavefront OBJ file with a mesh";
  EXPECT_EQ(message("\n"), expected);
  EXPECT_EQ(message("# nothing"), expected);
  EXPECT_EQ(message("g a\nf 1 2 3\n"), expected);
}

TEST(ObjErrors, NoFaces) {
  EXPECT_EQ(message("v 0 0 0\nl 1 1\n"), "mesh.obj: has no faces ('f' statements); give a mesh of polygons");
}

TEST(ObjErrors, NulBytes) {
  EXPECT_EQ(message("v 0 0 0\n\0\0\0"sv),
            "mesh.obj:2: holds NUL bytes and so is no text; give a Wavefront OBJ file in ASCII or UTF-8");
  EXPECT_EQ(refusal("v 0 0 0\n\0"sv).element, 2);
}

TEST(ObjErrors, BinaryDataFarDown) {
  const std::string text = std::string(5000, '#') + "\n" + withTriangle("\x01\x02\n");
  EXPECT_EQ(message(text), "mesh.obj:5: holds binary data; give a Wavefront OBJ file in ASCII or UTF-8");
}

TEST(ObjErrors, FirstStatementOfAnotherFormat) {
  EXPECT_EQ(message("ply\nformat ascii 1.0\n"), "mesh.obj:1: 'ply' begins no OBJ statement; give a Wavefront OBJ file");
  EXPECT_EQ(message("# c\n\n<?xml version?>"),
            "mesh.obj:3: '<?xml' begins no OBJ statement; give a Wavefront OBJ file");
}

TEST(ObjErrors, QuotedWordsAreShortAndPrintable) {
  EXPECT_EQ(message("\xFF\xFE\x7F" + std::string(1000, 'x')),
            "mesh.obj:1: '???" + std::string(37, 'x') + "...' begins no OBJ statement; give a Wavefront OBJ file");
}

TEST(ObjErrors, NotANumber) {
  const std::string rest = " is not a number; write a decimal number such as -0.5 or 1e-3";
  EXPECT_EQ(message("v 0 0 zero\n"), "mesh.obj:1: 'zero'" + rest);
  EXPECT_EQ(message("v 0 0 0\nv 1,5 0 0\n"), "mesh.obj:2: '1,5'" + rest);
  EXPECT_EQ(message("v 0 0 1.#INF\n"), "mesh.obj:1: '1.#INF'" + rest);
  EXPECT_EQ(message("v 0 0\\\n1e\n"), "mesh.obj:2: '1e'" + rest);
  EXPECT_EQ(message("v 0 0 0 x\n"), "mesh.obj:1: 'x'" + rest);
  EXPECT_EQ(message("v 0 0 0\nvt a\n"), "mesh.obj:2: 'a'" + rest);
  EXPECT_EQ(message("v 0 0 0\nvn 0 0 b\n"), "mesh.obj:2: 'b'" + rest);
}

TEST(ObjErrors, WrongCountOfNumbers) {
  EXPECT_EQ(message("v 1 2\n"), "mesh.obj:1: a vertex has 2 numbers; write v x y z");
  EXPECT_EQ(message("v\n"), "mesh.obj:1: a vertex has 0 numbers; write v x y z");
  EXPECT_EQ(message("v 1 2 3 4 5\n"), "mesh.obj:1: a vertex has 5 numbers; write v x y z");
  EXPECT_EQ(message("v 1 2 3 4 5 6 7 8\n"), "mesh.obj:1: a vertex has 8 numbers; write v x y z");
  EXPECT_EQ(message("vt\n"), "mesh.obj:1: a texture coordinate has 0 numbers; write vt u v");
  EXPECT_EQ(message("vt 1 2 3 4\n"), "mesh.obj:1: a texture coordinate has 4 numbers; write vt u v");
  EXPECT_EQ(message("vn 1 2\n"), "mesh.obj:1: a normal has 2 numbers; write vn x y z");
}

TEST(ObjErrors, NanAndInfinityNameTheVertex) {
  const std::string rest = "; give it a finite position";
  EXPECT_EQ(message("v 0 0 0\nv 0 nan 0\n"), "mesh.obj:2: vertex 2 (counted from 1) has the coordinate nan" + rest);
  EXPECT_EQ(message("v inf 0 0\n"), "mesh.obj:1: vertex 1 (counted from 1) has the coordinate inf" + rest);
  EXPECT_EQ(message("v 0 0 -1e400\n"), "mesh.obj:1: vertex 1 (counted from 1) has the coordinate -inf" + rest);
  const Error error = refusal("v 0 0 0\n\n\nv 0 0 inf\n");
  EXPECT_EQ(error.code, ErrorCode::invalidPositions);
  EXPECT_EQ(error.element, 1);
}

TEST(ObjErrors, NanInTextureCoordinateColourOrNormal) {
  EXPECT_EQ(message("vt nan 0\n"),
            "mesh.obj:1: a texture coordinate is not finite; give it finite numbers or remove it");
  EXPECT_EQ(message("v 0 0 0 0 nan 0\n"), "mesh.obj:1: a colour is not finite; give it finite numbers or remove it");
  EXPECT_EQ(message("vn 0 0 inf\n"), "mesh.obj:1: a normal is not finite; give it finite numbers or remove it");
}

TEST(ObjErrors, FewerThanThreeSides) {
  const std::string rest = "; write three or more, or remove the face";
  EXPECT_EQ(message(withTriangle("f 1 2\n")), "mesh.obj:4: a face has 2 corners" + rest);
  EXPECT_EQ(message(withTriangle("f 1\n")), "mesh.obj:4: a face has 1 corner" + rest);
  EXPECT_EQ(message(withTriangle("f 1 2 3\nf # 1 2 3\n")), "mesh.obj:5: a face has 0 corners" + rest);
}

TEST(ObjErrors, ZeroIndex) {
  EXPECT_EQ(message(withTriangle("f 0 1 2\n")),
            "mesh.obj:4: a face names vertex 0; count from 1, or from -1 backwards");
  EXPECT_EQ(message(withTriangle("vt 0 0\nf 1/0 2/1 3/1\n")),
            "mesh.obj:5: a face names texture coordinate 0; count from 1, or from -1 backwards");
  EXPECT_EQ(message(withTriangle("f 1//0 2 3\n")),
            "mesh.obj:4: a face names normal 0; count from 1, or from -1 backwards");
}

TEST(ObjErrors, IndexPastTheEndNamesTheFirstAndCountsTheRest) {
  EXPECT_EQ(message(withTriangle("f 1 2 3\nf 1 2 4\n")),
            "mesh.obj:5: a face names vertex 4, but the file has 3 vertices; correct the index");
  EXPECT_EQ(message(withTriangle("f 1 2 3\n\nf 1 2 4\nf 7 1 9\n")),
            "mesh.obj:6: a face names vertex 4, but the file has 3 vertices; correct the index (and 2 more)");
  EXPECT_EQ(message("v 0 0 0\nf 1 1 2\n"),
            "mesh.obj:2: a face names vertex 2, but the file has 1 vertex; correct the index");
  EXPECT_EQ(refusal(withTriangle("f 1 2 4\n")).element, 4);
  EXPECT_EQ(message(withTriangle("f 1 2 2147483647\n")),
            "mesh.obj:4: a face names vertex 2147483647, but the file has 3 vertices; correct the index");
}

TEST(ObjErrors, TextureCoordinateOrNormalPastTheEnd) {
  EXPECT_EQ(message(withTriangle("f 1 2 3\nf 1/1 2/1 3/1\n")),
            "mesh.obj:5: a face names texture coordinate 1, but the file has 0 texture coordinates; correct the index "
            "(and 2 more)");
  EXPECT_EQ(message(withTriangle("vn 0 0 1\nf 1//1 2//2 3//1\n")),
            "mesh.obj:5: a face names normal 2, but the file has 1 normal; correct the index");
}

TEST(ObjErrors, NegativeIndexBeforeTheBeginning) {
  EXPECT_EQ(message(withTriangle("f -4 -2 -1\n")),
            "mesh.obj:4: a face names vertex -4, but only 3 were read so far; correct the index");
  EXPECT_EQ(message("v 0 0 0\nf 1 1 -2\nv 0 0 0\n"),
            "mesh.obj:2: a face names vertex -2, but only 1 was read so far; correct the index");
  EXPECT_EQ(message(withTriangle("f 1 2 -99999999999999999999\n")),
            "mesh.obj:4: a face names vertex -9223372036854775808, but only 3 were read so far; correct the index");
}

TEST(ObjErrors, IndexNoFileCanHold) {
  EXPECT_EQ(message(withTriangle("f 1 2 2147483648\n")),
            "mesh.obj:4: a face names vertex 2147483648, more than a file can hold; correct the index");
}

TEST(ObjErrors, CornerThatIsNoWholeNumber) {
  const std::string rest = " is no face corner; write v, v/vt, v//vn or v/vt/vn in whole numbers";
  for (const char* corner : {"1.0", "a", "1/a", "1/1/a", "1/2/3/4", "/1", "-", "1e2", "1/-"}) {
    EXPECT_EQ(message(withTriangle("f 1 2 ") + corner + "\n"), std::string("mesh.obj:4: '") + corner + "'" + rest);
  }
  EXPECT_EQ(message(withTriangle("f 1 2 \\\nx\n")), "mesh.obj:5: 'x'" + rest);
}

TEST(ObjErrors, TooManyVerticesOrCorners) {
  const std::string text = withTriangle("f 1 2 3\nf 3 2 1\n");
  EXPECT_TRUE(parse(text, 6));
  EXPECT_EQ(refusal(text, 5).code, ErrorCode::tooLarge);
  EXPECT_EQ(refusal(text, 5).message, "mesh.obj:5: more than 5 face corners; split the mesh");
  EXPECT_EQ(refusal(text, 2).code, ErrorCode::tooLarge);
  EXPECT_EQ(refusal(text, 2).message, "mesh.obj:3: more than 2 vertices; split the mesh");
}

TEST(ObjErrors, FilesTheSystemRefuses) {
  const TemporaryFolder folder;
  const std::string missing = (folder / "missing.obj").string();
  const Result<Mesh> absent = readObj(missing);
  ASSERT_FALSE(absent);
  EXPECT_EQ(absent.error().code, ErrorCode::unreadable);
  EXPECT_EQ(absent.error().message, missing + ": cannot be read: No such file or directory; check the path");

  const std::string locked = (folder / "locked.obj").string();
  writeBytes(locked, "v 0 0 0\n");
  ASSERT_EQ(::chmod(locked.c_str(), 0), 0);
  const Unprivileged guard;
  const Result<Mesh> denied = readObj(locked);
  ASSERT_FALSE(denied);
  EXPECT_EQ(denied.error().message, locked + ": cannot be read: Permission denied; check the permissions");
}

TEST(ObjErrors, MessagesNameThePathAsGiven) {
  const TemporaryFolder folder;
  writeBytes(folder / "a.obj", "v 0 0 zero\n");
  const std::string path = (folder.path() / "." / "a.obj").string();
  const Result<Mesh> mesh = readObj(path);
  ASSERT_FALSE(mesh);
  EXPECT_EQ(mesh.error().message.substr(0, path.size() + 10), path + ":1: 'zero'");
}

}  // namespace
}  // namespace honeycomb::Io::Test
