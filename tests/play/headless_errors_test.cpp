#include "tests/cli/workplace.h"

namespace honeycomb::Test {
namespace {

using testing::HasSubstr;

class HeadlessErrorsTest : public Workplace {
 protected:
  std::vector<std::string> play(std::vector<std::string> options) const {
    options.insert(options.begin(), {"play", cube, "--headless", "--levels", "1"});
    return options;
  }

  std::string cube = file("cube.obj", cubeObj());
};

TEST_F(HeadlessErrorsTest, NothingToWrite) {
  EXPECT_REFUSED(play({}), HasSubstr("--headless: say what to write: --output frame_%04d.png"));
}

TEST_F(HeadlessErrorsTest, OneNameForManyPictures) {
  const std::string moves = cache("c.pc2", 8, 2, std::vector<float>(48, 0.5F));
  EXPECT_REFUSED(play({"--cache", moves, "--output", path("one.png")}),
                 HasSubstr("is one file for 2 pictures; number them, as frame_%04d.png"));
}

TEST_F(HeadlessErrorsTest, FormatsThatAreNone) {
  EXPECT_REFUSED(play({"--output", path("a.jpg")}), HasSubstr("pictures are .png files, videos .mp4"));
  EXPECT_REFUSED(play({"--sheet", path("a.mp4")}), HasSubstr("pictures are .png files"));
}

TEST_F(HeadlessErrorsTest, SizesThatAreNone) {
  for (const std::string size : {"64", "64x", "0x40", "64x40x2", "-64x40", "1e3x40"})
    EXPECT_REFUSED(play({"--output", path("a.png"), "--size", size}),
                   HasSubstr("--size " + size + ": give width and height in pixels"));
  EXPECT_REFUSED(play({"--output", path("a.png"), "--size", "1000000x40"}), HasSubstr("can't be drawn"));
}

TEST_F(HeadlessErrorsTest, ViewsAndBackendsThatAreNone) {
  EXPECT_REFUSED(play({"--output", path("a.png"), "--view", "xray"}),
                 HasSubstr("--view: there is no 'xray'; choose from: shaded, flat, cells"));
  EXPECT_REFUSED(play({"--output", path("a.png"), "--backend", "cuda"}), HasSubstr("--backend: there is no 'cuda'"));
}

TEST_F(HeadlessErrorsTest, AFrameThatOverflowsIsNamed) {
  std::vector<float> numbers(72, 0.5F);
  for (std::size_t i = 48; i < 72; i += 3) numbers[i] = 3e38F;
  const std::string moves = cache("c.pc2", 8, 3, numbers);
  EXPECT_REFUSED(play({"--cache", moves, "--output", path("f_%d.png")}), HasSubstr("c.pc2: frame 2: refined vertex"));
}

TEST_F(HeadlessErrorsTest, FramesOfAMeshThatHasNone) {
  EXPECT_REFUSED(play({"--frames", "0:2", "--output", path("f_%d.png")}), HasSubstr("holds one pose only"));
}

TEST_F(HeadlessErrorsTest, WhatCannotBeReadOrRefinedIsRefusedAsEverywhere) {
  EXPECT_REFUSED((std::vector<std::string>{"play", path("none.obj"), "--headless", "--output", path("a.png")}),
                 HasSubstr("none.obj"));
  EXPECT_REFUSED(play({"--output", path("a.png"), "--tension", "7"}), HasSubstr("tension"));
}

}  // namespace
}  // namespace honeycomb::Test
