#include "io/ply_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/io/files.h"
#include "tests/io/random_reals.h"

namespace honeycomb::Io::Test {
namespace {

using Integers = std::vector<std::int32_t>;

template <class... Numbers>
std::string raw(const Numbers&... numbers) {
  std::string bytes;
  (bytes.append(reinterpret_cast<const char*>(&numbers), sizeof numbers), ...);
  return bytes;
}

class PlyWriter : public testing::Test {
 protected:
  const TemporaryFolder folder_;
  const std::vector<float> positions_{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0.5F};
  const Integers offsets_{0, 3, 6}, corners_{0, 1, 2, 0, 2, 3};
  ObjContent<float> content_{positions_, {}, offsets_, corners_};

  std::string written() const {
    const Result<void> done = writePly(folder_ / "a.ply", content_);
    EXPECT_TRUE(done) << done.error().message;
    return readBytes(folder_ / "a.ply");
  }
  std::string points() const { return {reinterpret_cast<const char*>(positions_.data()), 48}; }
  std::string faces() const { return raw(std::uint8_t{3}, 0, 1, 2) + raw(std::uint8_t{3}, 0, 2, 3); }
  static std::string head(const std::string& vertex, const std::string& face) {
    return "ply\nformat binary_little_endian 1.0\ncomment honeycomb\nelement vertex 4\n"
           "property float x\nproperty float y\nproperty float z\n" +
           vertex + "element face 2\nproperty list uchar int vertex_indices\n" + face + "end_header\n";
  }
};

TEST_F(PlyWriter, PositionsAndFaces) {
  EXPECT_EQ(written(), head("", "") + points() + faces());
}

TEST_F(PlyWriter, NormalsColoursAndTexcoordsStandBehindEachPosition) {
  const std::vector<float> normals(12, 0.25F), colours{0, 0.5F, 1, 1, 1, 1, -3, 2, 0, 0.1F, 0.2F, 0.3F};
  const std::vector<float> texcoords{0, 0, 0.5F, 0.75F};
  content_.normals = normals;
  content_.colours = colours;
  content_.texcoords = texcoords;
  const Integers same{0, 1, 1, 0, 1, -1};
  content_.cornerTexcoords = same;
  const std::string text = written();
  const std::string header = head(
      "property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\nproperty uchar green\n"
      "property uchar blue\nproperty float s\nproperty float t\n",
      "");
  ASSERT_TRUE(text.starts_with(header)) << text;
  const std::string normal = raw(0.25F, 0.25F, 0.25F);
  const auto vertex = [&](std::size_t v, const std::string& colour, float s, float t) {
    return points().substr(12 * v, 12) + normal + colour + raw(s, t);
  };
  EXPECT_EQ(text.substr(header.size()),
            vertex(0, {'\0', '\x80', '\xFF'}, 0, 0) + vertex(1, {'\xFF', '\xFF', '\xFF'}, 0.5F, 0.75F) +
                vertex(2, {'\0', '\xFF', '\0'}, 0.5F, 0.75F) + vertex(3, {'\x1A', '\x33', '\x4D'}, 0, 0) + faces());
}

TEST_F(PlyWriter, SeamsAreTexcoordsOfTheFaces) {
  const std::vector<float> texcoords{0, 0, 0.5F, 0.75F};
  content_.texcoords = texcoords;
  const Integers seam{0, 1, 1, 1, 1, -1};
  content_.cornerTexcoords = seam;
  const std::string uv = raw(0.5F, 0.75F), none = raw(0.0F, 0.0F), six = raw(std::uint8_t{6});
  EXPECT_EQ(written(), head("", "property list uchar float texcoord\n") + points() + raw(std::uint8_t{3}, 0, 1, 2) +
                           six + none + uv + uv + raw(std::uint8_t{3}, 0, 2, 3) + six + uv + uv + none);
}

TEST_F(PlyWriter, FacesOfManySidesHaveLongCounts) {
  std::vector<float> ring(3 * 256);
  Integers corners(256);
  for (std::size_t i = 0; i < 256; ++i) corners[i] = static_cast<std::int32_t>(i);
  const Integers offsets{0, 256};
  content_ = {ring, {}, offsets, corners};
  EXPECT_THAT(written(), testing::HasSubstr("property list uint int vertex_indices\n"));
}

TEST_F(PlyWriter, DoublesKeepTheirBits) {
  const std::vector<double> values = randomReals<double>(300);
  ASSERT_TRUE(writePly<double>(folder_ / "a.ply", {values, {}, offsets_, corners_}));
  const std::string text = readBytes(folder_ / "a.ply");
  EXPECT_THAT(text, testing::HasSubstr("property double x\n"));
  const std::string_view bytes(reinterpret_cast<const char*>(values.data()), 2400);
  EXPECT_NE(text.find(bytes), std::string::npos);
}

TEST_F(PlyWriter, RefusesWhatTheObjWriterRefuses) {
  const std::vector<float> bad{0, 0, 0, NAN, 0, 0, 1, 1, 0, 0, 1, 0};
  content_.positions = bad;
  const Result<void> done = writePly(folder_ / "a.ply", content_);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::invalidPositions);
  EXPECT_EQ(done.error().element, 1);
  EXPECT_EQ(folder_.entries(), 0);
}

}  // namespace
}  // namespace honeycomb::Io::Test
