#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "io/obj.h"
#include "tests/io/files.h"

namespace honeycomb::Io::Test {
namespace {

const std::vector<std::int32_t> kOffsets{0, 3};
const std::vector<std::int32_t> kCorners{0, 1, 2};
const std::vector<float> kPositions{0, 0.1F, -0.0F, 1e10F, 1, 0, 0, 1, 1e-10F};

Error writeRefusal(const ObjContent<float>& content) {
  const TemporaryFolder folder;
  const Result<void> written = writeObj<float>(folder / "a.obj", content);
  EXPECT_EQ(folder.entries(), 0) << "a refused mesh left a file";
  if (!written) return written.error();
  ADD_FAILURE() << "written";
  return {};
}

TEST(ObjWriter, WritesNineDigitsForSinglePrecision) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeObj<float>(folder / "a.obj", {kPositions, {}, kOffsets, kCorners}));
  EXPECT_EQ(readBytes(folder / "a.obj"), "v 0 0.100000001 -0\nv 1e+10 1 0\nv 0 1 1.00000001e-10\nf 1 2 3\n");
}

TEST(ObjWriter, WritesSeventeenDigitsForDoublePrecision) {
  const TemporaryFolder folder;
  const std::vector<double> positions{0, 0.1, -0.0, 1e10, 1, 0, 0, 1, 1e-10};
  ASSERT_TRUE(writeObj<double>(folder / "a.obj", {positions, {}, kOffsets, kCorners}));
  EXPECT_EQ(readBytes(folder / "a.obj"), "v 0 0.10000000000000001 -0\nv 10000000000 1 0\nv 0 1 1e-10\nf 1 2 3\n");
}

TEST(ObjWriter, GivesEveryVertexItsNormal) {
  const TemporaryFolder folder;
  const std::vector<float> normals{0, 0, 1, 0, 1, 0, 1, 0, 0};
  ASSERT_TRUE(writeObj<float>(folder / "a.obj", {kPositions, normals, kOffsets, kCorners}));
  const std::string text = readBytes(folder / "a.obj");
  EXPECT_EQ(text.substr(text.find("vn")), "vn 0 0 1\nvn 0 1 0\nvn 1 0 0\nf 1//1 2//2 3//3\n");
}

TEST(ObjWriter, WritesColoursBehindPositions) {
  const TemporaryFolder folder;
  const std::vector<float> colours{1, 0, 0, 0, 0.5, 0, 0, 0, 0.1F};
  ASSERT_TRUE(writeObj<float>(folder / "a.obj", {kPositions, {}, kOffsets, kCorners, colours}));
  EXPECT_EQ(readBytes(folder / "a.obj"),
            "v 0 0.100000001 -0 1 0 0\nv 1e+10 1 0 0 0.5 0\nv 0 1 1.00000001e-10 0 0 0.100000001\nf 1 2 3\n");
}

TEST(ObjWriter, CornersNameTextureCoordinatesAndNormals) {
  const TemporaryFolder folder;
  const std::vector<float> normals(9, 1);
  const std::vector<float> texcoords{0, 0.5, 1, 0.25};
  const std::vector<std::int32_t> corners{1, -1, 0};
  ObjContent<float> content{kPositions, {}, kOffsets, kCorners, {}, texcoords, corners};
  ASSERT_TRUE(writeObj<float>(folder / "a.obj", content));
  std::string text = readBytes(folder / "a.obj");
  EXPECT_EQ(text.substr(text.find("vt")), "vt 0 0.5\nvt 1 0.25\nf 1/2 2 3/1\n");
  content.normals = normals;
  ASSERT_TRUE(writeObj<float>(folder / "a.obj", content));
  text = readBytes(folder / "a.obj");
  EXPECT_EQ(text.substr(text.find('f')), "f 1/2/1 2//2 3/1/3\n");
}

TEST(ObjWriter, RefusesNanAndInfinityBeforeWriting) {
  std::vector<float> positions = kPositions;
  positions[4] = NAN;
  const Error error = writeRefusal({positions, {}, kOffsets, kCorners});
  EXPECT_EQ(error.code, ErrorCode::invalidPositions);
  EXPECT_EQ(error.element, 1);
  EXPECT_EQ(error.message.substr(error.message.rfind("a.obj")),
            "a.obj: not written: the position of vertex 1 (counted from 0) has the coordinate nan; scale the mesh down "
            "or compute in double precision");
  std::vector<float> normals(9, 1.0F);
  normals[8] = INFINITY;
  EXPECT_EQ(writeRefusal({kPositions, normals, kOffsets, kCorners}).element, 2);
  EXPECT_EQ(writeRefusal({kPositions, {}, kOffsets, kCorners, normals}).element, 2);
  const std::vector<float> texcoords{0, 0, 0, NAN};
  EXPECT_EQ(writeRefusal({kPositions, {}, kOffsets, kCorners, {}, texcoords, kCorners}).code, ErrorCode::invalidMesh);
  const std::vector<std::int32_t> named{0, 0, 1};
  EXPECT_EQ(writeRefusal({kPositions, {}, kOffsets, kCorners, {}, texcoords, named}).element, 1);
}

TEST(ObjWriter, RefusesCornersWithoutVertex) {
  const std::vector<std::int32_t> corners{0, 1, 3};
  const Error error = writeRefusal({kPositions, {}, kOffsets, corners});
  EXPECT_EQ(error.code, ErrorCode::invalidMesh);
  EXPECT_EQ(error.message, "face 0 names vertex 3 of 3; correct the index");
  EXPECT_EQ(error.element, 0);
  const std::vector<float> texcoords{0, 0, 1, 1};
  EXPECT_EQ(writeRefusal({kPositions, {}, kOffsets, kCorners, {}, texcoords, kCorners}).message,
            "face 0 names texture coordinate 2 of 2; correct the index");
}

TEST(ObjWriter, RefusesArraysThatDoNotFitTogether) {
  const std::vector<float> normals(6, 1.0F);
  const std::vector<std::int32_t> descending{0, 3, 2, 3};
  const std::vector<std::int32_t> tooFew{0, 2};
  EXPECT_EQ(writeRefusal({std::span(kPositions).first(8), {}, kOffsets, kCorners}).code, ErrorCode::invalidOption);
  EXPECT_EQ(writeRefusal({kPositions, normals, kOffsets, kCorners}).code, ErrorCode::invalidOption);
  EXPECT_EQ(writeRefusal({kPositions, {}, {}, kCorners}).code, ErrorCode::invalidOption);
  EXPECT_EQ(writeRefusal({kPositions, {}, kOffsets, kCorners, normals}).code, ErrorCode::invalidOption);
  EXPECT_EQ(writeRefusal({kPositions, {}, kOffsets, kCorners, {}, normals, tooFew}).code, ErrorCode::invalidOption);
  EXPECT_EQ(writeRefusal({kPositions, {}, descending, kCorners}).code, ErrorCode::invalidOption);
  EXPECT_EQ(writeRefusal({kPositions, {}, tooFew, kCorners}).code, ErrorCode::invalidOption);
}

TEST(ObjWriter, FullDiskLeavesNoFile) {
  const TemporaryFolder folder;
  const std::vector<float> positions(300000, 0.1F);
  const std::string path = (folder / "a.obj").string();
  const FileSizeLimit limit(100000);
  const Result<void> written = writeObj<float>(path, {positions, {}, kOffsets, kCorners});
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::unwritable);
  EXPECT_EQ(written.error().message,
            path + ": cannot be written: File too large; free some space or choose another place");
  EXPECT_EQ(folder.entries(), 0);
}

}  // namespace
}  // namespace honeycomb::Io::Test
