#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "apps/viewer/look.h"
#include "tests/cli/workplace.h"
#include "tests/play/pictures.h"

namespace honeycomb::Test {
namespace {

constexpr int kFrames = 4;

/// A torus that bends, drawn small.
class HeadlessTest : public Workplace {
 protected:
  HeadlessTest() {
    const std::string torus = torusObj(8);
    mesh = file("torus.obj", torus);
    std::vector<float> numbers;
    for (int f = 0; f < kFrames; ++f) {
      const std::vector<float> frame = bentFrame(torus, f);
      numbers.insert(numbers.end(), frame.begin(), frame.end());
    }
    frames = cache("torus.pc2", 64, kFrames, numbers);
  }

  Outcome play(std::vector<std::string> options, const std::string& size = "160x100") const {
    options.insert(options.begin(), {"play", mesh, "--headless", "--levels", "2", "--size", size});
    return run(options, {.environment = {kLeaksOfDrivers}});
  }
  /// One picture of the first frame.
  Viewer::Picture picture(std::vector<std::string> options, const std::string& size = "160x100") const {
    const std::string name = path("picture.png");
    options.insert(options.end(), {"--output", name});
    const Outcome done = play(options, size);
    EXPECT_EQ(done.exitCode, 0) << done.err;
    return readPng(name);
  }

  std::string mesh, frames;
};

TEST_F(HeadlessTest, WritesAPictureAFrameUnderItsNumber) {
  const Outcome done = play({"--cache", frames, "--frames", "1:4", "--output", path("f_%03d.png")});
  ASSERT_EQ(done.exitCode, 0) << done.err;
  EXPECT_EQ(done.err, "");
  EXPECT_THAT(listing(), testing::IsSupersetOf({"f_001.png", "f_002.png", "f_003.png"}));
  EXPECT_THAT(listing(), testing::Not(testing::Contains("f_000.png")));
  EXPECT_GT(difference(readPng(path("f_001.png")), readPng(path("f_003.png"))), 0.01) << "the torus moves";
  const Viewer::Picture first = readPng(path("f_001.png"));
  EXPECT_EQ(first.width, 160);
  EXPECT_EQ(first.height, 100);
}

TEST_F(HeadlessTest, WhatEachLevelTookOnTheDeviceIsInTheSummary) {
  const auto levelsOn = [&](const std::string& backend) {
    const Outcome done = play(
        {"--cache", frames, "--frames", "0:1", "--backend", backend, "--output", path("l_%d.png"), "--json"}, "96x60");
    EXPECT_EQ(done.exitCode, 0) << done.err;
    return nlohmann::json::parse(done.out).at("device_levels");
  };
  const nlohmann::json levels = levelsOn("vulkan");
  ASSERT_EQ(levels.size(), 3U) << levels << ": two levels, and the limits of the last";
  EXPECT_EQ(levels[2]["what"], "limits");
  for (const nlohmann::json& level : levels) EXPECT_GT(level["ms"], 0) << levels;
  EXPECT_EQ(levelsOn("serial").size(), 0U) << "the CPU has no such clock";
}

TEST_F(HeadlessTest, PicturesAreTheSameBytesAgainAndOnEveryBackend) {
  std::string expected;
  for (const std::string backend : {"serial", "tbb", "vulkan", "auto", "serial"}) {
    const Outcome done =
        play({"--cache", frames, "--cage", "--normals-shown", "--backend", backend, "--output", path("f_%d.png")});
    ASSERT_EQ(done.exitCode, 0) << done.err;
    const std::string bytes = read("f_0.png") + read("f_3.png");
    if (expected.empty()) expected = bytes;
    EXPECT_TRUE(bytes == expected) << backend;
  }
}

TEST_F(HeadlessTest, EveryViewDiffersFromTheOthers) {
  std::vector<Viewer::Picture> pictures;
  for (const Viewer::Look& look : Viewer::looks()) {
    pictures.push_back(picture({"--view", std::string(look.name)}));
    for (std::size_t other = 0; other + 1 < pictures.size(); ++other)
      EXPECT_GT(difference(pictures[other], pictures.back(), 6), 0.02)
          << look.name << " and " << Viewer::looks()[other].name;
  }
}

double brightness(const Viewer::Picture& picture) {
  double sum = 0;
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
    sum += picture.rgba[i] + picture.rgba[i + 1] + picture.rgba[i + 2];
  return sum / static_cast<double>(picture.rgba.size());
}

TEST_F(HeadlessTest, EdgesAreDrawnOrNotWhateverTheView) {
  const std::string size = "320x200";
  const Viewer::Picture plain = picture({"--view", "shaded"}, size);
  const Viewer::Picture outlined = picture({"--view", "shaded", "--edges"}, size);
  EXPECT_GT(difference(plain, outlined), 0.05);
  EXPECT_LT(brightness(outlined), brightness(plain)) << "edges are dark";
  const Viewer::Picture cells = picture({"--view", "cells"}, size);
  const Viewer::Picture bare = picture({"--view", "cells", "--no-edges"}, size);
  EXPECT_LT(brightness(cells), brightness(bare));
  EXPECT_EQ(picture({"--view", "cells", "--edges"}, size).rgba, cells.rgba) << "as the view has them";
}

TEST_F(HeadlessTest, TheCageAndTheNormalsAreDrawnOverTheSurface) {
  const Viewer::Picture bare = picture({"--view", "shaded"}, "320x200");
  EXPECT_GT(difference(picture({"--view", "shaded", "--cage"}, "320x200"), bare), 0.02);
  const Viewer::Picture normals = picture({"--view", "shaded", "--normals-shown"}, "320x200");
  EXPECT_GT(difference(normals, bare), 0.02);
  const auto blueish = [](const Colour& c) { return c.blue > c.red + 20; };
  EXPECT_GT(shareOf(normals, blueish), shareOf(bare, blueish) + 0.004) << "normals are blue lines";
}

TEST_F(HeadlessTest, ExtraordinaryCellsAreRedAmongPaleHexagons) {
  // The torus has squares only, each a face-face in the middle of hexagons.
  const auto red = [](const Colour& c) { return c.red > 2 * c.green && c.red > 60; };
  EXPECT_GT(shareOf(picture({"--view", "extraordinary"}), red), 0.003);
  EXPECT_LT(shareOf(picture({"--view", "shaded"}), red), 1e-9);
}

TEST_F(HeadlessTest, FlatCellsArePaleAndBentOnesAreNotInTheViewOfPlanarity) {
  const auto warm = [](const Colour& c) { return c.red > c.blue + 60; };
  const std::string cube = file("cube.obj", cubeObj());
  const Outcome done = run({"play", cube, "--headless", "--levels", "1", "--size", "160x100", "--scheme", "doo-sabin",
                            "--view", "planarity", "--output", path("cube.png")},
                           {.environment = {kLeaksOfDrivers}});
  ASSERT_EQ(done.exitCode, 0) << done.err;
  EXPECT_LT(shareOf(readPng(path("cube.png")), warm), 0.001) << "a cube with its corners cut off has flat faces";
  EXPECT_GT(shareOf(picture({"--view", "planarity"}), warm), 0.05);
}

TEST_F(HeadlessTest, AStillMeshIsOnePictureOrATurntable) {
  EXPECT_EQ(play({"--output", path("still.png")}).exitCode, 0);
  const Outcome turned = play({"--turntable", "20", "--output", path("t_%d.png"), "--json"}, "96x60");
  ASSERT_EQ(turned.exitCode, 0) << turned.err;
  EXPECT_EQ(nlohmann::json::parse(turned.out)["pictures"], 4);
  EXPECT_THAT(listing(), testing::IsSupersetOf({"t_0.png", "t_3.png"}));
  EXPECT_GT(difference(readPng(path("t_0.png")), readPng(path("t_3.png"))), 0.005);
}

TEST_F(HeadlessTest, ASheetHasSomeOfThePictures) {
  const Outcome done = play({"--cache", frames, "--frames", "0:2", "--sheet", path("sheet.png")}, "96x20");
  ASSERT_EQ(done.exitCode, 0) << done.err;
  const Viewer::Picture sheet = readPng(path("sheet.png"));
  EXPECT_EQ(sheet.width, 2 * (480 + 12) + 12);
  EXPECT_EQ(sheet.height, 100 + 2 * 12) << "two frames are one row";
}

TEST_F(HeadlessTest, SchemesWithoutLimitNormalsAreShownFlat) {
  const Outcome done = play({"--scheme", "catmull-clark", "--normals-shown", "--output", path("p.png")});
  ASSERT_EQ(done.exitCode, 0) << done.err;
  EXPECT_GT(difference(readPng(path("p.png")), picture({})), 0.02);
}

}  // namespace
}  // namespace honeycomb::Test
