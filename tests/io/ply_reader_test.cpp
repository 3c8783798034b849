#include <gmock/gmock.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "io/ply.h"
#include "tests/support/random.h"

namespace honeycomb::Io::Test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Parses a copy in a buffer of exactly the size, so that a sanitizer sees every read past its end.
Result<Mesh> parseExactly(std::string_view bytes, std::int64_t maxElements = 2147483647) {
  const auto exact = std::make_unique<char[]>(bytes.size());
  std::copy(bytes.begin(), bytes.end(), exact.get());
  return parsePly({exact.get(), bytes.size()}, "mesh.ply", maxElements);
}

Mesh parsedPly(std::string_view bytes) {
  Result<Mesh> mesh = parseExactly(bytes);
  if (mesh) return *std::move(mesh);
  ADD_FAILURE() << mesh.error().message;
  return {};
}

std::string plyRefusal(std::string_view bytes) {
  const Result<Mesh> mesh = parseExactly(bytes);
  return mesh ? "accepted" : mesh.error().message;
}

std::string plyHeader(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\ncomment of nobody\nelement vertex 4\nproperty float x\nproperty double y\nproperty short z\n"
         "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float s\nproperty float t\n"
         "element edge 1\nproperty list uchar int ends\n"
         "element face 2\nproperty uchar flag\nproperty list uchar int vertex_indices\nend_header\n";
}

const std::string kTextPly = plyHeader("ascii") +
                             "0 0.5 0 255 0 51 0 0\n1 0 0 0 0 0 1 0\n1 1 0 0 0 0 1 1\n0 1 -7 0 0 0 0 1\n"
                             "2 0 3\n"
                             "9 3 0 1 2\n9 4 3 2 1 0\n";

template <class Number>
void append(std::string& bytes, bool big, Number number) {
  std::string raw(sizeof number, '\0');
  std::memcpy(raw.data(), &number, sizeof number);
  if (big) std::reverse(raw.begin(), raw.end());
  bytes += raw;
}

/// The same file in binary.
std::string binaryPly(bool big) {
  std::string bytes = plyHeader(big ? "binary_big_endian" : "binary_little_endian");
  const double points[4][5] = {{0, 0.5, 0, 0, 0}, {1, 0, 0, 1, 0}, {1, 1, 0, 1, 1}, {0, 1, -7, 0, 1}};
  for (int v = 0; v < 4; ++v) {
    append(bytes, big, static_cast<float>(points[v][0]));
    append(bytes, big, points[v][1]);
    append(bytes, big, static_cast<std::int16_t>(points[v][2]));
    for (const int part : {255, 0, 51}) append(bytes, big, static_cast<std::uint8_t>(v == 0 ? part : 0));
    append(bytes, big, static_cast<float>(points[v][3]));
    append(bytes, big, static_cast<float>(points[v][4]));
  }
  const auto list = [&](const std::vector<std::int32_t>& values) {
    append(bytes, big, static_cast<std::uint8_t>(values.size()));
    for (const std::int32_t value : values) append(bytes, big, value);
  };
  list({0, 3});
  bytes += '\x09', list({0, 1, 2});
  bytes += '\x09', list({3, 2, 1, 0});
  return bytes;
}

TEST(PlyReader, AllEncodingsGiveTheSameMesh) {
  for (const std::string& bytes : {kTextPly, binaryPly(false), binaryPly(true)}) {
    const Mesh mesh = parsedPly(bytes);
    EXPECT_EQ(mesh.polygons.vertexCount, 4);
    EXPECT_THAT(mesh.positions, ElementsAre(0, 0.5, 0, 1, 0, 0, 1, 1, 0, 0, 1, -7));
    EXPECT_THAT(mesh.polygons.faceOffsets, ElementsAre(0, 3, 7));
    EXPECT_THAT(mesh.polygons.indices, ElementsAre(0, 1, 2, 3, 2, 1, 0));
    EXPECT_THAT(mesh.colours, ElementsAre(1, 0, 0.2, 0, 0, 0, 0, 0, 0, 0, 0, 0));
    EXPECT_THAT(mesh.texcoords, ElementsAre(0, 0, 1, 0, 1, 1, 0, 1));
    EXPECT_EQ(mesh.cornerTexcoords, mesh.polygons.indices);
  }
}

TEST(PlyReader, LinesAreKnownOfTextAlone) {
  EXPECT_THAT(parsedPly(kTextPly).vertexLines, ElementsAre(19, 20, 21, 22));
  EXPECT_THAT(parsedPly(kTextPly).faceLines, ElementsAre(24, 25));
  EXPECT_THAT(parsedPly(binaryPly(false)).faceLines, IsEmpty());
}

TEST(PlyReader, CornersMayHaveTextureCoordinates) {
  const Mesh mesh = parsedPly(
      "ply\r\nformat ascii 1.0\r\nelement vertex 3\r\nproperty float x\r\nproperty float y\r\nproperty float z\r\n"
      "element face 2\r\nproperty list uchar int vertex_index\r\nproperty list uchar float texcoord\r\nend_header\r\n"
      "0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2 6 0 0 1 0 0 1\r\n3 2 1 0 0\r\n");
  EXPECT_THAT(mesh.texcoords, ElementsAre(0, 0, 1, 0, 0, 1));
  EXPECT_THAT(mesh.cornerTexcoords, ElementsAre(0, 1, 2, -1, -1, -1));
}

TEST(PlyReader, ErrorsOfTheHeaderNameTheirLine) {
  EXPECT_EQ(plyRefusal(""), "mesh.ply: is empty; give a PLY file");
  EXPECT_EQ(plyRefusal("v 0 0 0\n"), "mesh.ply:1: does not begin with 'ply'; give a PLY file");
  EXPECT_THAT(plyRefusal("ply\nformat ascii 2.0\n"), HasSubstr("mesh.ply:2: is an unknown format"));
  EXPECT_THAT(plyRefusal("ply\nend_header\n"), HasSubstr("mesh.ply:2: the header names no format"));
  EXPECT_THAT(plyRefusal("ply\nformat ascii 1.0\nelement vertex -1\n"), HasSubstr("mesh.ply:3: is no element"));
  EXPECT_THAT(plyRefusal("ply\nformat ascii 1.0\nproperty float x\n"), HasSubstr("mesh.ply:3: is no property"));
  EXPECT_THAT(plyRefusal("ply\nformat ascii 1.0\nelement a 1\nproperty list float int x\n"),
              HasSubstr("mesh.ply:4: is no property"));
  EXPECT_THAT(plyRefusal("ply\nformat ascii 1.0\nelement face 1\nelement face 1\n"),
              HasSubstr("mesh.ply:4: is a second element 'face'"));
  EXPECT_THAT(plyRefusal("ply\nformat ascii 1.0\n"), HasSubstr("mesh.ply:2: the header has no end"));
}

TEST(PlyReader, ErrorsOfTheBodySayWhere) {
  const auto replaced = [](std::string text, const std::string& what, const std::string& by) {
    return text.replace(text.rfind(what), what.size(), by);
  };
  EXPECT_THAT(plyRefusal(replaced(kTextPly, "-7", "x")), HasSubstr("mesh.ply:22: the file ends, or 'z' is no number"));
  EXPECT_THAT(plyRefusal(replaced(kTextPly, "-7", "nan")), HasSubstr("mesh.ply:22: vertex 4 (counted from 1) has the"));
  EXPECT_THAT(plyRefusal(replaced(kTextPly, "3 0 1 2", "2 0 1")), HasSubstr("mesh.ply:24: a face has 2 corners"));
  EXPECT_THAT(plyRefusal(replaced(kTextPly, "3 0 1 2", "3 0 1 4")),
              HasSubstr("mesh.ply:24: face 0 (counted from 0) names vertex 4, but there are 4"));
  EXPECT_THAT(plyRefusal(replaced(kTextPly, "3 0 1 2", "3 0 -1 2")), HasSubstr("a face names vertex -1; count from 0"));
  const std::string binary = binaryPly(false);
  EXPECT_THAT(plyRefusal(binary.substr(0, binary.size() - 1)), HasSubstr("mesh.ply: face 1 (counted from 0, byte"));
  EXPECT_EQ(parseExactly(kTextPly, 3).error().code, ErrorCode::tooLarge);
}

TEST(PlyReader, FilesWithFlippedBytesAreReadOrRefused) {
  honeycomb::Test::Random random(7);
  for (const std::string& whole : {kTextPly, binaryPly(false), binaryPly(true)}) {
    for (int i = 0; i < 3000; ++i) {
      std::string bytes = whole.substr(0, random.chance(0.3) ? random.below(whole.size()) : whole.size());
      for (std::size_t k = random.below(5); k > 0 && !bytes.empty(); --k)
        bytes[random.below(bytes.size())] = static_cast<char>(random.below(256));
      const Result<Mesh> mesh = parseExactly(bytes);
      if (!mesh) continue;
      for (const std::int32_t v : mesh->polygons.indices) EXPECT_LT(v, mesh->polygons.vertexCount);
      EXPECT_EQ(mesh->positions.size(), 3 * static_cast<std::size_t>(mesh->polygons.vertexCount));
    }
  }
}

}  // namespace
}  // namespace honeycomb::Io::Test
