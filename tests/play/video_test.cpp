#include <filesystem>

#include "apps/cli/play/video_pipe.h"
#include "tests/cli/workplace.h"
#include "tests/play/pictures.h"

namespace honeycomb::Test {
namespace {

using testing::HasSubstr;

/// In the place of ffmpeg stands a script of the test's, which is all that is on the PATH.
class VideoTest : public Workplace {
 protected:
  void ffmpegIs(const std::string& script) const {
    std::filesystem::create_directory(path("bin"));
    const std::string program = file("bin/ffmpeg", "#!/bin/sh\n" + script);
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  }
  Outcome play(const std::string& output) const {
    return run(
        {"play", cube, "--headless", "--levels", "1", "--size", "64x40", "--turntable", "15", "--output", output},
        {.environment = {{"PATH", path("bin")}, kLeaksOfDrivers}});
  }

  std::string cube = file("cube.obj", cubeObj());
};

TEST_F(VideoTest, FfmpegIsGivenEveryPictureRaw) {
  ffmpegIs("for last; do :; done\necho \"$@\" > \"$last.options\"\n/bin/cat > \"$last\"\n");
  const Outcome done = play(path("clip.mp4"));
  ASSERT_EQ(done.exitCode, 0) << done.err;
  EXPECT_EQ(read("clip.mp4").size(), 3U * 64 * 40 * 4);
  EXPECT_THAT(read("clip.mp4.options"),
              testing::AllOf(HasSubstr("-f rawvideo -pix_fmt rgba -s 64x40 -r 24 -i -"), HasSubstr("clip.mp4")));
}

TEST_F(VideoTest, WithoutFfmpegTheErrorSaysWhatElseToDo) {
  const Outcome done = play(path("clip.mp4"));
  EXPECT_EQ(done.exitCode, 1);
  EXPECT_TRUE(isOneErrorLine(done.err)) << done.err;
  EXPECT_THAT(done.err, testing::AllOf(HasSubstr("clip.mp4: videos are made by ffmpeg, which isn't installed"),
                                       HasSubstr("--output frame_%04d.png")));
}

TEST_F(VideoTest, WhatFfmpegLeavesUnfinishedIsRemoved) {
  ffmpegIs("for last; do :; done\necho half > \"$last\"\nexit 3\n");
  const Outcome done = play(path("clip.webm"));
  EXPECT_EQ(done.exitCode, 1);
  EXPECT_TRUE(isOneErrorLine(done.err)) << done.err;
  EXPECT_THAT(done.err, HasSubstr("clip.webm: ffmpeg"));
  EXPECT_FALSE(std::filesystem::exists(path("clip.webm")));
}

TEST(VideoNameTest, IsToldByItsExtension) {
  EXPECT_TRUE(Cli::Play::isVideo("a.MP4"));
  EXPECT_TRUE(Cli::Play::isVideo("b/c.webm"));
  EXPECT_FALSE(Cli::Play::isVideo("mp4"));
  EXPECT_FALSE(Cli::Play::isVideo("frame_%04d.png"));
}

}  // namespace
}  // namespace honeycomb::Test
