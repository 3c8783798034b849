#include "apps/viewer/contact_sheet.h"

#include <gtest/gtest.h>

#include "tests/viewer/cube.h"

namespace honeycomb::ViewerTests {
namespace {

Viewer::Picture plain(std::int32_t width, std::int32_t height, std::uint8_t level) {
  Viewer::Picture picture{width, height, {}};
  picture.rgba.assign(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), level);
  return picture;
}

TEST(ContactSheet, LaysPicturesOutInRows) {
  const std::vector pictures{plain(4, 3, 10), plain(4, 3, 20), plain(4, 3, 30)};
  const Viewer::Picture sheet = Viewer::contactSheet(pictures, {2, 1, Viewer::Rgb{0x010203}});
  EXPECT_EQ(sheet.width, 11);
  EXPECT_EQ(sheet.height, 9);
  EXPECT_EQ(pixelAt(sheet, 0, 0).blue, 3) << "the gap shows the paper";
  EXPECT_EQ(pixelAt(sheet, 1, 1).red, 10);
  EXPECT_EQ(pixelAt(sheet, 4, 3).red, 10);
  EXPECT_EQ(pixelAt(sheet, 5, 3).red, 1);
  EXPECT_EQ(pixelAt(sheet, 6, 1).red, 20);
  EXPECT_EQ(pixelAt(sheet, 1, 5).red, 30);
  EXPECT_EQ(pixelAt(sheet, 6, 5).red, 1) << "the place of a fourth picture stays empty";
}

TEST(ContactSheet, OfNothingIsEmpty) {
  EXPECT_TRUE(Viewer::contactSheet({}, {}).rgba.empty());
}

}  // namespace
}  // namespace honeycomb::ViewerTests
