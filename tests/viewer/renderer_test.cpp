#include "apps/viewer/renderer.h"

#include <gtest/gtest.h>
#include <png.h>

#include <filesystem>

#include "io/png.h"
#include "tests/viewer/cube.h"
#include "tests/vulkan/fixture.h"

namespace honeycomb::ViewerTests {
namespace {

constexpr std::uint32_t kGreen = 0xff30a020U;
constexpr Viewer::RendererOptions kSize{160, 120};

/// The cube from the front, without a ground.
Viewer::View frontView(const Cube& cube) {
  Viewer::View view;
  view.bounds = Viewer::boundsOf(cube.points);
  view.camera = Viewer::frameAll(cube.points, {0, 0, 1}, 160.0F / 120.0F, 0.4F, 0.2F);
  view.style.ground = false;
  view.style.faceted = true;
  return view;
}

class RendererTest : public VulkanTests::VulkanTest {
 protected:
  void SetUp() override {
    VulkanTest::SetUp();
    auto created = Viewer::Renderer::create(context->device(), kSize);
    ASSERT_TRUE(created) << created.error().message;
    renderer.emplace(std::move(*created));
  }
  void TearDown() override {
    renderer.reset();
    VulkanTest::TearDown();
  }

  Viewer::Picture draw(const Cube& cube, const Viewer::View& view) {
    const auto mesh = renderer->upload(cube.content());
    const auto points = renderer->uploadPoints(cube.points);
    const auto normals = renderer->uploadPoints(cube.normals);
    auto picture = renderer->draw(mesh.value(), {points.value().get(), 0, 3}, {normals.value().get(), 0, 3}, view);
    return std::move(picture.value());
  }

  std::optional<Viewer::Renderer> renderer;
};

TEST_F(RendererTest, BackgroundWhereNothingIsAndColourWhereTheCellIs) {
  const Cube cube(kGreen);
  const Viewer::Picture picture = draw(cube, frontView(cube));
  ASSERT_EQ(picture.rgba.size(), 4U * 160 * 120);
  const Pixel corner = pixelAt(picture, 3, 3);
  EXPECT_NEAR(corner.red, corner.green, 16) << "the backdrop is nearly grey";
  EXPECT_GT(corner.sum(), 3 * 130);
  const Pixel cell = pixelAt(picture, 70, 70);
  EXPECT_GT(cell.green, 2 * cell.red);
  EXPECT_GT(cell.green, 2 * cell.blue);
}

TEST_F(RendererTest, EdgesAreDarkerThanCellsAndVanishAtStrengthZero) {
  const Cube cube(kGreen);
  Viewer::View view = frontView(cube);
  view.style.edgeWidth = 6;
  view.style.edgeStrength = 1;
  // From this side the cube's front vertical edge runs down the middle of the picture.
  view.camera = Viewer::frameAll(cube.points, {1, 0, 1}, 160.0F / 120.0F, 0.4F, 0.2F);
  const Pixel edge = pixelAt(draw(cube, view), 80, 60);
  view.style.edgeStrength = 0;
  const Viewer::Picture without = draw(cube, view);
  EXPECT_LT(2 * edge.green, pixelAt(without, 80, 60).green);
  EXPECT_NEAR(pixelAt(without, 81, 60).green, pixelAt(without, 85, 60).green, 6);
}

TEST_F(RendererTest, GroundTakesTheShadow) {
  const Cube cube(kGreen);
  Viewer::View view = frontView(cube);
  view.camera = Viewer::frameAll(cube.points, {0, 0.8F, 1}, 160.0F / 120.0F, 0.4F, 0.3F);
  const Viewer::Picture bare = draw(cube, view);
  view.style.ground = true;
  const Viewer::Picture grounded = draw(cube, view);
  // The key light stands on the left, so the shadow falls to the right.
  EXPECT_LT(pixelAt(grounded, 105, 64).sum() + 60, pixelAt(bare, 105, 64).sum());
  EXPECT_NEAR(pixelAt(grounded, 4, 4).sum(), pixelAt(bare, 4, 4).sum(), 30);
}

TEST_F(RendererTest, NormalsShadeUnlessFaceted) {
  Cube cube(kGreen);
  Viewer::View view = frontView(cube);
  view.style.faceted = false;
  const Pixel lit = pixelAt(draw(cube, view), 70, 70);
  for (std::size_t i = 0; i < cube.normals.size(); i += 3) {
    cube.normals[i] = 0;
    cube.normals[i + 1] = -1;
    cube.normals[i + 2] = 0;
  }
  EXPECT_LT(pixelAt(draw(cube, view), 70, 70).green, lit.green - 40) << "turned away from all lights";
}

TEST_F(RendererTest, ReadsPointsAtAnyOffsetAndStride) {
  const Cube cube(kGreen);
  const Viewer::View view = frontView(cube);
  const Viewer::Picture packed = draw(cube, view);
  std::vector<float> spread(5 + 7 * 8, -9999);
  for (std::size_t v = 0; v < 8; ++v) {
    for (std::size_t c = 0; c < 3; ++c) spread[5 + 7 * v + c] = cube.points[3 * v + c];
  }
  const auto mesh = renderer->upload(cube.content());
  const auto points = renderer->uploadPoints(spread);
  const auto normals = renderer->uploadPoints(cube.normals);
  const auto picture = renderer->draw(mesh.value(), {points.value().get(), 5, 7}, {normals.value().get(), 0, 3}, view);
  ASSERT_TRUE(picture) << picture.error().message;
  EXPECT_EQ(picture->rgba, packed.rgba);
}

TEST_F(RendererTest, PictureComesBackFromItsPng) {
  const Cube cube(kGreen);
  const Viewer::Picture picture = draw(cube, frontView(cube));
  const auto path = std::filesystem::path(testing::TempDir()) / "honeycomb_renderer_test.png";
  const auto written = Io::writePng(path, picture.width, picture.height, picture.rgba);
  ASSERT_TRUE(written) << written.error().message;
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_file(&image, path.c_str()), 0) << image.message;
  image.format = PNG_FORMAT_RGBA;
  std::vector<std::uint8_t> read(PNG_IMAGE_SIZE(image));
  ASSERT_NE(png_image_finish_read(&image, nullptr, read.data(), 0, nullptr), 0) << image.message;
  std::filesystem::remove(path);
  EXPECT_EQ(read, picture.rgba);
}

TEST_F(RendererTest, RefusesWhatItCannotDraw) {
  const auto none = Viewer::Renderer::create(context->device(), {0, 100});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, ErrorCode::invalidOption);
  EXPECT_EQ(none.error().message.substr(0, 51), "a picture of 0 x 100 pixels can't be drawn; each si");

  Cube cube(kGreen);
  const auto mesh = renderer->upload(cube.content());
  const auto points = renderer->uploadPoints(cube.points);
  ASSERT_TRUE(mesh && points);
  const Viewer::PointSource packed{points->get(), 0, 3};
  const auto far = renderer->draw(*mesh, {points->get(), 0, 1 << 30}, packed, frontView(cube));
  ASSERT_FALSE(far);
  EXPECT_EQ(far.error().code, ErrorCode::tooLarge);
  const auto narrow = renderer->draw(*mesh, packed, {points->get(), 0, 2}, frontView(cube));
  ASSERT_FALSE(narrow);
  EXPECT_EQ(narrow.error().message, "the normals to draw have offset 0 and stride 2; they must be at least 0 and 3");

  cube.corners[5] = 8;
  const auto broken = renderer->upload(cube.content());
  ASSERT_FALSE(broken);
  EXPECT_EQ(broken.error().code, ErrorCode::invalidMesh);
}

}  // namespace
}  // namespace honeycomb::ViewerTests
