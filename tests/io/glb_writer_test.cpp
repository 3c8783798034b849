#include "io/glb_writer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "io/block_writer.h"
#include "io/stream_writer.h"
#include "io/unfinished_frames.h"
#include "tests/io/files.h"

namespace honeycomb::Io::Test {
namespace {

using Json = nlohmann::json;

/// Reads a .glb by the specification, and checks what it says of chunks, views and accessors.
class GlbFile {
 public:
  explicit GlbFile(const std::filesystem::path& path) : bytes_(readBytes(path)) {
    EXPECT_EQ(bytes_.substr(0, 4), "glTF");
    EXPECT_EQ(word(4), 2U);
    EXPECT_EQ(word(8), bytes_.size());
    const std::size_t jsonBytes = word(12), binary = 20 + jsonBytes;
    EXPECT_EQ(jsonBytes % 4, 0U);
    EXPECT_EQ(bytes_.substr(16, 4), "JSON");
    json_ = Json::parse(bytes_.substr(20, jsonBytes));
    EXPECT_EQ(bytes_.substr(binary + 4, 4), std::string("BIN\0", 4));
    EXPECT_EQ(word(binary), bytes_.size() - binary - 8);
    EXPECT_EQ(json_["buffers"][0]["byteLength"], word(binary));
    data_ = binary + 8;
    for (std::size_t a = 0; a < json_["accessors"].size(); ++a) checkAccessor(json_["accessors"][a]);
  }
  const Json& json() const { return json_; }
  const Json& primitive() const { return json_["meshes"][0]["primitives"][0]; }
  template <class Number>
  std::vector<Number> numbers(std::size_t accessor) const {
    const Json& a = json_["accessors"][accessor];
    std::vector<Number> result(a["count"].get<std::size_t>() * width(a));
    std::memcpy(result.data(), bytes_.data() + begin(a), 4 * result.size());
    return result;
  }
  std::vector<float> attribute(const std::string& name) const {
    return numbers<float>(primitive()["attributes"].at(name).get<std::size_t>());
  }
  /// The positions at a key of the animation: base and targets by that key's weights.
  std::vector<float> frame(std::size_t key) const {
    std::vector<float> points = attribute("POSITION");
    const Json& sampler = json_["animations"][0]["samplers"][0];
    const std::vector<float> weights = numbers<float>(sampler["output"].get<std::size_t>());
    const std::size_t targets = primitive()["targets"].size();
    for (std::size_t t = 0; t < targets; ++t) {
      const auto delta = numbers<float>(primitive()["targets"][t]["POSITION"].get<std::size_t>());
      for (std::size_t i = 0; i < points.size(); ++i) points[i] += weights[key * targets + t] * delta[i];
    }
    return points;
  }

 private:
  std::uint32_t word(std::size_t offset) const {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes_.data() + offset, 4);
    return value;
  }
  static std::size_t width(const Json& accessor) {
    return accessor["type"] == "SCALAR" ? 1 : static_cast<std::size_t>(accessor["type"].get<std::string>()[3] - '0');
  }
  std::size_t begin(const Json& accessor) const {
    const Json& view = json_["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    return data_ + view["byteOffset"].get<std::size_t>() + accessor.value("byteOffset", std::size_t{0});
  }
  void checkAccessor(const Json& a) const {
    const Json& view = json_["bufferViews"][a["bufferView"].get<std::size_t>()];
    EXPECT_EQ(begin(a) % 4, 0U);
    EXPECT_LE(a.value("byteOffset", 0U) + a["count"].get<std::size_t>() * width(a) * 4, view["byteLength"]);
    EXPECT_LE(data_ + view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>(), bytes_.size());
    if (!a.contains("min")) return;
    const auto* numbers = reinterpret_cast<const float*>(bytes_.data() + begin(a));
    for (std::size_t k = 0; k < width(a); ++k) {
      float least = INFINITY, most = -INFINITY;
      for (std::size_t i = 0; i < a["count"]; ++i) {
        least = std::min(least, numbers[i * width(a) + k]);
        most = std::max(most, numbers[i * width(a) + k]);
      }
      EXPECT_EQ(a["min"][k].get<float>(), least);
      EXPECT_EQ(a["max"][k].get<float>(), most);
    }
  }

  std::string bytes_;
  Json json_;
  std::size_t data_ = 0;
};

class GlbWriter : public testing::Test {
 protected:
  const TemporaryFolder folder_;
  const std::filesystem::path path_ = folder_ / "a.glb";
  const std::vector<float> positions_{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0.5F};
  const std::vector<std::int32_t> offsets_{0, 3, 6}, corners_{0, 1, 2, 0, 2, 3};
  ObjContent<float> content_{positions_, {}, offsets_, corners_};

  GlbFile written() const {
    const Result<void> done = writeGlb(path_, content_);
    EXPECT_TRUE(done) << done.error().message;
    return GlbFile(path_);
  }
  static std::vector<float> moved(const std::vector<float>& points, float by) {
    std::vector<float> result = points;
    for (std::size_t i = 0; i < result.size(); ++i) result[i] += by * static_cast<float>(i % 5);
    return result;
  }
  GlbFile baked(std::int32_t frames, float rate) const {
    const auto layout = glbLayout("a.glb", content_, {4, frames, 0, rate, 0});
    EXPECT_TRUE(layout) << layout.error().message;
    auto file = UnfinishedFile::open(path_, *layout, {});
    EXPECT_TRUE(file);
    BlockWriter writer("a.glb", *layout, *openBlockFile((*file)->partialFile(), path_),
                       *openBlockFile((*file)->journal(), path_));
    for (std::int32_t f = frames - 1; f >= 0; --f)
      EXPECT_TRUE(writer.write(f, moved(positions_, 0.125F * static_cast<float>(f))));
    EXPECT_TRUE(writer.close());
    const Result<void> finished = (*file)->finish();
    EXPECT_TRUE(finished) << finished.error().message;
    return GlbFile(path_);
  }
};

TEST_F(GlbWriter, AMeshIsItsTriangles) {
  const GlbFile file = written();
  EXPECT_EQ(file.json()["asset"]["version"], "2.0");
  EXPECT_EQ(file.attribute("POSITION"), positions_);
  EXPECT_EQ(file.primitive()["mode"], 4);
  EXPECT_EQ(file.numbers<std::uint32_t>(file.primitive()["indices"].get<std::size_t>()),
            (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
  EXPECT_FALSE(file.json().contains("animations"));
}

TEST_F(GlbWriter, NormalsAndColoursAreAttributes) {
  const std::vector<float> normals(12, 0.5F), colours(12, 0.75F);
  content_.normals = normals;
  content_.colours = colours;
  const GlbFile file = written();
  EXPECT_EQ(file.attribute("NORMAL"), normals);
  EXPECT_EQ(file.attribute("COLOR_0"), colours);
}

TEST_F(GlbWriter, TexcoordsCountDownwardsAndSeamsSplitVertices) {
  const std::vector<float> texcoords{0, 0, 0.5F, 0.75F};
  const std::vector<std::int32_t> seam{0, 1, 1, 1, 1, -1};
  content_.texcoords = texcoords;
  content_.cornerTexcoords = seam;
  const GlbFile file = written();
  const auto points = file.attribute("POSITION"), uv = file.attribute("TEXCOORD_0");
  const auto indices = file.numbers<std::uint32_t>(file.primitive()["indices"].get<std::size_t>());
  ASSERT_EQ(points.size(), 15U) << "vertex 0 is two";
  ASSERT_EQ(indices.size(), 6U);
  for (std::size_t c = 0; c < 6; ++c) {
    const auto corner = static_cast<std::size_t>(corners_[c]);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(points[3 * indices[c] + k], positions_[3 * corner + k]) << c;
    const float u = seam[c] == 1 ? 0.5F : 0, v = seam[c] == 1 ? 0.25F : 1;
    EXPECT_EQ(uv[2 * indices[c]], u) << c;
    EXPECT_EQ(uv[2 * indices[c] + 1], v) << c;
  }
}

TEST_F(GlbWriter, FramesAreMorphTargetsAtTheirTimes) {
  const GlbFile file = baked(5, 0.25F);
  const Json& animation = file.json()["animations"][0];
  EXPECT_EQ(animation["channels"][0]["target"], Json::parse(R"({"node":0,"path":"weights"})"));
  EXPECT_EQ(animation["samplers"][0]["interpolation"], "LINEAR");
  EXPECT_EQ(file.numbers<float>(animation["samplers"][0]["input"].get<std::size_t>()),
            (std::vector<float>{0, 0.25F, 0.5F, 0.75F, 1}));
  EXPECT_EQ(file.primitive()["targets"].size(), 4U);
  for (std::size_t f = 0; f < 5; ++f)
    EXPECT_EQ(file.frame(f), moved(positions_, 0.125F * static_cast<float>(f))) << "frame " << f;
}

TEST_F(GlbWriter, OneFrameDoesntMove) {
  EXPECT_FALSE(baked(1, 0).json().contains("animations"));
}

TEST_F(GlbWriter, WhatReadersCannotTakeIsRefusedBeforehand) {
  std::vector<float> many(3 * 1'000'000);
  content_.positions = many;
  const auto layout = glbLayout("a.glb", content_, {1'000'000, 200, 0, 1, 0});
  ASSERT_FALSE(layout);
  EXPECT_EQ(layout.error().code, ErrorCode::tooLarge);
  EXPECT_EQ(
      layout.error().message,
      "a.glb: 200 frames of 1000000 points are 2.4 GB, and glTF readers take 2.1 GB; bake to .pc2 with --mesh, or "
      "fewer --frames");
}

TEST_F(GlbWriter, TimesThatDontAscendAreRefused) {
  EXPECT_EQ(glbLayout("a.glb", content_, {4, 2, 0, 0, 0}).error().code, ErrorCode::invalidOption);
  EXPECT_EQ(glbLayout("a.glb", content_, {4, 2, 0, NAN, 0}).error().code, ErrorCode::invalidOption);
}

TEST_F(GlbWriter, MeshesWithoutFacesAreRefused) {
  const std::vector<std::int32_t> none{0};
  content_.faceOffsets = none;
  content_.faceVertices = {};
  EXPECT_EQ(writeGlb(path_, content_).error().code, ErrorCode::invalidOption);
  EXPECT_EQ(folder_.entries(), 0);
}

TEST_F(GlbWriter, DoublesTooLargeForSinglePrecisionAreRefused) {
  const std::vector<double> positions{0, 0, 0, 1e300, 0, 0, 1, 1, 0, 0, 1, 0};
  const Result<void> done = writeGlb<double>(path_, {positions, {}, offsets_, corners_});
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::invalidPositions);
}

}  // namespace
}  // namespace honeycomb::Io::Test
