#include <gmock/gmock.h>
#include <sys/stat.h>

#include <cmath>
#include <string>
#include <thread>

#include "io/obj.h"
#include "tests/io/files.h"
#include "tests/io/parse.h"

namespace honeycomb::Io::Test {
namespace {

using testing::ElementsAre;

TEST(ObjReader, KeepsPolygonsOfAnySideCount) {
  const Mesh mesh = parsed("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 2 2\nf 1 2 3\nf 1 2 3 4\nf 5 4 3 2 1\n");
  EXPECT_EQ(mesh.polygons.vertexCount, 5);
  EXPECT_THAT(mesh.polygons.faceOffsets, ElementsAre(0, 3, 7, 12));
  EXPECT_EQ(mesh.polygons.indices, (Indices{0, 1, 2, 0, 1, 2, 3, 4, 3, 2, 1, 0}));
  EXPECT_TRUE(mesh.polygons.corners.empty());
  EXPECT_THAT(mesh.position(2), ElementsAre(1, 1, 0));
}

TEST(ObjReader, ReadsNumbersInEveryNotation) {
  const Mesh mesh = parsed("v +1 -2.5 .5\nv 1e-3 1E+2 3.\nv 0.1 1e-400 -0\nf 1 2 3\n");
  EXPECT_EQ(mesh.positions, (Numbers{1, -2.5, .5, 1e-3, 1e2, 3, 0.1, 0, -0.0}));
  EXPECT_TRUE(std::signbit(mesh.positions[8]));
}

TEST(ObjReader, PassesOverWeightOfVertices) {
  const Mesh mesh = parsed("v 1 2 3 1\nv 4 5 6 .5\nv 7 8 9\nf 1 2 3\n");
  EXPECT_EQ(mesh.positions, (Numbers{1, 2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_TRUE(mesh.colours.empty());
}

TEST(ObjReader, ReadsColoursOfVerticesAndWhiteWhereThereIsNone) {
  const Mesh mesh = parsed("v 1 2 3 1\nv 4 5 6 .1 .2 .3\nv 7 8 9 1 .4 .5 .6\nv 0 0 0\nf 1 2 3\n");
  EXPECT_EQ(mesh.positions, (Numbers{1, 2, 3, 4, 5, 6, 7, 8, 9, 0, 0, 0}));
  EXPECT_EQ(mesh.colours, (Numbers{1, 1, 1, .1, .2, .3, .4, .5, .6, 1, 1, 1}));
}

TEST(ObjReader, ReadsTextureCoordinatesAndNormals) {
  const Mesh mesh = parsed(withTriangle("vt .25\nvt .5 .75\nvt 1 2 3\nvn 0 0 1\nvn 0 1 0\nf 1 2 3\n"));
  EXPECT_EQ(mesh.texcoords, (Numbers{.25, 0, .5, .75, 1, 2}));
  EXPECT_EQ(mesh.normals, (Numbers{0, 0, 1, 0, 1, 0}));
  EXPECT_TRUE(mesh.cornerTexcoords.empty());
  EXPECT_TRUE(mesh.cornerNormals.empty());
}

TEST(ObjReader, LineEndsMayBeLfCrLfOrCr) {
  for (const std::string_view end : {"\n", "\r\n", "\r"}) {
    std::string text;
    for (const char* line : {"v 0 0 0", "v 1 0 0", "", "v 0 1 0", "f 1 2 3"}) text.append(line).append(end);
    const Mesh mesh = parsed(text);
    EXPECT_EQ(mesh.polygons.indices, (Indices{0, 1, 2}));
    EXPECT_THAT(mesh.vertexLines, ElementsAre(1, 2, 4));
    EXPECT_THAT(mesh.faceLines, ElementsAre(5));
  }
}

TEST(ObjReader, LastLineNeedsNoEnd) {
  EXPECT_EQ(parsed(withTriangle("f 1 2 3")).polygons.indices, (Indices{0, 1, 2}));
  EXPECT_EQ(parsed(withTriangle("f 1 2 3\\")).polygons.indices, (Indices{0, 1, 2}));
  EXPECT_EQ(parsed(std::string("f 1 2 3\n").append(kTriangleVertices.substr(0, 23))).positions[7], 1);
}

TEST(ObjReader, WordsAreSeparatedByBlanksAndTabs) {
  EXPECT_EQ(parsed("\tv\t0  0\t 0 \n  v 1 0 0\t\nv 0 1 0\n f\t1 2\t3 \n").polygons.indices, (Indices{0, 1, 2}));
}

TEST(ObjReader, PassesOverCommentsAndByteOrderMark) {
  const Mesh mesh = parsed(std::string("\xEF\xBB\xBF# v 9 9 9\n") + withTriangle("  # indented\nf 1 2 3 # 4 5\n#"));
  EXPECT_EQ(mesh.polygons.indices, (Indices{0, 1, 2}));
}

TEST(ObjReader, BackslashContinuesStatementsButNotComments) {
  const Mesh mesh =
      parsed("# made in C:\\models\\\nv 0 \\\n 0 0\nv 1 0\\\r\n 0\nv 0 1 0\nf\\\n1 \\\n\\\n2 3\nf 3 2 1\n");
  EXPECT_EQ(mesh.polygons.indices, (Indices{0, 1, 2, 2, 1, 0}));
  EXPECT_THAT(mesh.vertexLines, ElementsAre(2, 4, 6));
  EXPECT_THAT(mesh.faceLines, ElementsAre(7, 11));
}

TEST(ObjReader, PassesOverAllOtherStatements) {
  const Mesh mesh =
      parsed(std::string("mtllib C:\\a\\b.mtl\no body\ng a b\ns off\nusemtl #1\n") +
             withTriangle("vp 1 2\nl 1 2\np 1\nparm u 0 \\\n1 2\ncsh -x y\nunheard of\n\xD0\xB4 1\nf 1 2 3\nend\n"));
  EXPECT_EQ(mesh.polygons.indices, (Indices{0, 1, 2}));
  EXPECT_EQ(mesh.polygons.faceCount(), 1);
}

TEST(ObjReader, ReadsFacesOfTheFirstFormatVersion) {
  EXPECT_EQ(parsed(withTriangle("fo 1 2 3\n")).polygons.indices, (Indices{0, 1, 2}));
}

TEST(ObjReader, LinesMayBeOfAnyLength) {
  constexpr std::int32_t kSides = 100000;
  std::string text;
  for (std::int32_t i = 0; i < kSides; ++i) text.append("v ").append(std::to_string(i)).append(" 0 0\n");
  text += "f";
  for (std::int32_t i = 1; i <= kSides; ++i) text.append(" ").append(std::to_string(i));
  const Mesh mesh = parsed(text + " #" + std::string(1 << 20, ' '));
  ASSERT_EQ(mesh.polygons.faceCount(), 1);
  ASSERT_EQ(mesh.polygons.indices.size(), std::size_t{kSides});
  EXPECT_EQ(mesh.polygons.indices.back(), kSides - 1);
}

TEST(ObjReader, ReadsFilesAndPipes) {
  const TemporaryFolder folder;
  const std::string text = withTriangle("f 1 2 3\n");
  writeBytes(folder / "mesh.obj", text);
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  std::thread writer([&] { writeBytes(folder / "pipe", text); });
  const Result<Mesh> piped = readObj(folder / "pipe");
  writer.join();
  const Result<Mesh> mapped = readObj(folder / "mesh.obj");
  ASSERT_TRUE(piped && mapped);
  EXPECT_EQ(piped->polygons.indices, (Indices{0, 1, 2}));
  EXPECT_EQ(mapped->positions, piped->positions);
}

TEST(ObjReader, EveryCutOfAFileIsAMeshOrAnError) {
  const std::string text =
      "\xEF\xBB\xBF# c\r\nv 1e-3 +2 -3.5\\\n\nv 1 2 3 1\rv 0 0 1e400\nvt .5 .5\nvn 0 0 1\nf 1/1/1 -2//-1 \\\n3/1 #x\n";
  for (std::size_t length = 0; length <= text.size(); ++length) {
    const Result<Mesh> mesh = parse(std::string_view(text).substr(0, length));
    EXPECT_TRUE(mesh || mesh.error().message.starts_with("mesh.obj:")) << length;
  }
}

TEST(ObjReader, EveryChangedByteGivesAMeshWithinBoundsOrAnError) {
  const std::string text = withTriangle("vt 0 0\nvn 0 0 1\ng a\nf 1/1/1 2/-1 3//1\nf -1 -2 \\\n-3\n");
  for (std::size_t at = 0; at < text.size(); ++at) {
    for (int byte = 0; byte < 256; ++byte) {
      std::string changed = text;
      changed[at] = static_cast<char>(byte);
      const Result<Mesh> mesh = parse(changed);
      if (!mesh) continue;
      for (const std::int32_t v : mesh->polygons.indices) ASSERT_TRUE(v >= 0 && v < mesh->polygons.vertexCount);
      ASSERT_EQ(mesh->polygons.faceOffsets.back(), static_cast<std::int64_t>(mesh->polygons.indices.size()));
    }
  }
}

}  // namespace
}  // namespace honeycomb::Io::Test
