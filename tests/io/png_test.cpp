#include "io/png.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cstdint>
#include <string>
#include <vector>

#include "tests/io/files.h"

namespace honeycomb::Io::Test {
namespace {

struct Picture {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint8_t> rgba;
};

Picture readPng(const std::filesystem::path& path) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_file(&image, path.c_str()), 0) << image.message;
  image.format = PNG_FORMAT_RGBA;
  Picture picture{image.width, image.height, std::vector<std::uint8_t>(PNG_IMAGE_SIZE(image))};
  EXPECT_NE(png_image_finish_read(&image, nullptr, picture.rgba.data(), 0, nullptr), 0) << image.message;
  return picture;
}

std::string pictureRefusal(std::int32_t width, std::int32_t height, std::size_t bytes) {
  const Result<void> written = writePng("a.png", width, height, std::vector<std::uint8_t>(bytes));
  if (written) return "written";
  EXPECT_EQ(written.error().code, ErrorCode::invalidOption);
  return written.error().message;
}

TEST(Png, PixelsComeBackUnchanged) {
  const TemporaryFolder folder;
  std::vector<std::uint8_t> rgba;
  for (std::uint32_t i = 0; i < 5 * 7 * 4; ++i) rgba.push_back(static_cast<std::uint8_t>(i * 97 % 256));
  const Result<void> written = writePng(folder / "a.png", 5, 7, rgba);
  ASSERT_TRUE(written) << written.error().message;
  const Picture picture = readPng(folder / "a.png");
  EXPECT_EQ(picture.width, 5U);
  EXPECT_EQ(picture.height, 7U);
  EXPECT_EQ(picture.rgba, rgba);
  EXPECT_EQ(folder.entries(), 1);
}

TEST(Png, RefusesSizesThatCannotBe) {
  EXPECT_EQ(pictureRefusal(0, 7, 0), "a.png: a picture of 0 x 7 pixels cannot be; give sides of 1 to 32768");
  EXPECT_EQ(pictureRefusal(7, -1, 0), "a.png: a picture of 7 x -1 pixels cannot be; give sides of 1 to 32768");
  EXPECT_EQ(pictureRefusal(32769, 1, 131076),
            "a.png: a picture of 32769 x 1 pixels cannot be; give sides of 1 to 32768");
  EXPECT_EQ(pictureRefusal(2, 2, 15), "a.png: a picture of 2 x 2 pixels needs 16 bytes, not 15; give RGBA");
}

TEST(Png, FullDiskIsAnError) {
  const Result<void> written = writePng("/dev/full", 2, 2, std::vector<std::uint8_t>(16));
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().message,
            "/dev/full: cannot be written: No space left on device; free some space or choose another place");
}

}  // namespace
}  // namespace honeycomb::Io::Test
