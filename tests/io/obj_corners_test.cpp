#include "io/obj.h"
#include "tests/io/parse.h"

namespace honeycomb::Io::Test {
namespace {

const std::string kThreeOfEach = withTriangle("vt 0 0\nvt 1 0\nvt 0 1\nvn 1 0 0\nvn 0 1 0\nvn 0 0 1\n");

Mesh withCorners(std::string_view faces) {
  return parsed(kThreeOfEach + std::string(faces));
}

TEST(ObjCorners, MayNameTextureCoordinatesAndNormals) {
  const Mesh mesh = withCorners("f 1/3/2 2/2/1 3/1/3\n");
  EXPECT_EQ(mesh.polygons.indices, (Indices{0, 1, 2}));
  EXPECT_EQ(mesh.cornerTexcoords, (Indices{2, 1, 0}));
  EXPECT_EQ(mesh.cornerNormals, (Indices{1, 0, 2}));
}

TEST(ObjCorners, MayNameTextureCoordinatesAlone) {
  const Mesh mesh = withCorners("f 1/3 2/2 3/1\n");
  EXPECT_EQ(mesh.cornerTexcoords, (Indices{2, 1, 0}));
  EXPECT_TRUE(mesh.cornerNormals.empty());
}

TEST(ObjCorners, MayNameNormalsAlone) {
  const Mesh mesh = withCorners("f 1//3 2//2 3//1\n");
  EXPECT_TRUE(mesh.cornerTexcoords.empty());
  EXPECT_EQ(mesh.cornerNormals, (Indices{2, 1, 0}));
}

TEST(ObjCorners, WhatACornerDoesNotNameIsMinusOne) {
  const Mesh mesh = withCorners("f 1 2 3\nf 1/1 2 3//3\nf 3 2/2/2 1\n");
  EXPECT_EQ(mesh.cornerTexcoords, (Indices{-1, -1, -1, 0, -1, -1, -1, 1, -1}));
  EXPECT_EQ(mesh.cornerNormals, (Indices{-1, -1, -1, -1, -1, 2, -1, 1, -1}));
}

TEST(ObjCorners, TrailingSlashesAreLetPass) {
  const Mesh mesh = withCorners("f 1/ 2// 3/1/\n");
  EXPECT_EQ(mesh.polygons.indices, (Indices{0, 1, 2}));
  EXPECT_EQ(mesh.cornerTexcoords, (Indices{-1, -1, 0}));
  EXPECT_TRUE(mesh.cornerNormals.empty());
}

TEST(ObjCorners, NegativeIndicesCountBackFromWhatWasRead) {
  const Mesh mesh =
      parsed(withTriangle("vt 0 0\nvn 0 0 1\nf -3/-1/-1 -2/-1/-1 -1/-1/-1\nv 9 9 9\nvt 1 1\nf -1 -2/-1 -3\n"));
  EXPECT_EQ(mesh.polygons.indices, (Indices{0, 1, 2, 3, 2, 1}));
  EXPECT_EQ(mesh.cornerTexcoords, (Indices{0, 0, 0, -1, 1, -1}));
  EXPECT_EQ(mesh.cornerNormals, (Indices{0, 0, 0, -1, -1, -1}));
}

TEST(ObjCorners, PositiveIndicesMayNameWhatFollows) {
  const Mesh mesh = parsed(std::string("f +1/1/1 2/1/1 3/1/1\nvt 0 0\nvn 0 0 1\n").append(kTriangleVertices));
  EXPECT_EQ(mesh.polygons.indices, (Indices{0, 1, 2}));
  EXPECT_EQ(mesh.cornerNormals, (Indices{0, 0, 0}));
}

}  // namespace
}  // namespace honeycomb::Io::Test
