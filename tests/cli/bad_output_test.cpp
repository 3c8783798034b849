#include <csignal>

#include "workplace.h"

namespace honeycomb::Test {
namespace {

using testing::HasSubstr;

class BadOutputTest : public Workplace {
 protected:
  std::vector<std::string> refine(const std::string& out) const {
    return {"refine", file("cube.obj", cubeObj()), out, "--levels", "5"};
  }
  std::string torusCache(int n, int frames) const {
    std::vector<float> numbers;
    const std::vector<float> frame = bentFrame(torusObj(n), 1);
    for (int f = 0; f < frames; ++f) numbers.insert(numbers.end(), frame.begin(), frame.end());
    return cache("in.pc2", n * n, frames, numbers);
  }
};

TEST_F(BadOutputTest, MissingFolderIsRefused) {
  EXPECT_REFUSED(refine(path("none/out.obj")), HasSubstr(path("none/out.obj")), HasSubstr("No such file"));
}

TEST_F(BadOutputTest, FolderAsOutputIsRefused) {
  std::filesystem::create_directory(path("out.obj"));
  EXPECT_REFUSED(refine(path("out.obj")), HasSubstr(path("out.obj")), HasSubstr("folder"));
}

TEST_F(BadOutputTest, WhatTheSystemWontCreateIsRefused) {
  EXPECT_REFUSED(refine("/proc/out.obj"), HasSubstr("/proc/out.obj"));
}

TEST_F(BadOutputTest, FullDiskIsRefused) {
  std::filesystem::create_symlink("/dev/full", path("out.obj"));
  std::filesystem::create_symlink("/dev/full", path("out.pc2"));
  EXPECT_REFUSED(refine(path("out.obj")), HasSubstr("out.obj"), HasSubstr("No space left"));
  EXPECT_REFUSED(
      (std::vector<std::string>{"bake", file("torus.obj", torusObj(8)), path("out.pc2"), "--cache", torusCache(8, 9)}),
      HasSubstr("out.pc2"), HasSubstr("No space left"));
}

TEST_F(BadOutputTest, FileSizeLimitLeavesNothingBehind) {
  const std::string in = file("torus.obj", torusObj(8)), frames = torusCache(8, 9);
  const auto before = listing();
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"refine", in, path("out.obj"), "--levels", "4"},
        {"bake", in, path("out.pc2"), "--cache", frames},
        {"bake", in, path("out.pc2"), "--cache", frames, "--mesh", path("out.obj")}}) {
    const Outcome outcome = run(arguments, {{}, 5000});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_TRUE(isOneErrorLine(outcome.err)) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("File too large"));
    EXPECT_EQ(listing(), before);
  }
}

TEST_F(BadOutputTest, WritingOverAnInputIsRefused) {
  const std::string in = file("cube.obj", cubeObj()), frames = cache("in.pc2", 8, 1, bentFrame(cubeObj(), 0));
  const std::string sameFile = path("./cube.obj");
  std::filesystem::create_symlink(in, path("link.obj"));
  for (const std::string& out : {in, sameFile, path("link.obj")})
    EXPECT_REFUSED((std::vector<std::string>{"refine", in, out}), HasSubstr(out), HasSubstr("another output"));
  EXPECT_REFUSED((std::vector<std::string>{"convert", in, in, "--to", "dual"}), HasSubstr("another output"));
  EXPECT_REFUSED((std::vector<std::string>{"bake", in, frames, "--cache", frames}), HasSubstr("another output"));
  EXPECT_REFUSED((std::vector<std::string>{"bake", in, path("out.pc2"), "--cache", frames, "--mesh", in}),
                 HasSubstr("another output"));
  EXPECT_EQ(read("cube.obj"), cubeObj());
}

TEST_F(BadOutputTest, AnExistingOutputSurvivesAnError) {
  const std::string out = file("out.obj", "precious");
  EXPECT_EQ(run(refine(out), {{}, 10000}).exitCode, 1);
  EXPECT_EQ(read("out.obj"), "precious");
}

TEST_F(BadOutputTest, InterruptedRefineLeavesNothing) {
  const std::string in = file("torus.obj", torusObj(16));
  const auto before = listing();
  for (const int signal : {SIGINT, SIGTERM}) {
    EXPECT_EQ(run({"refine", in, path("out.obj"), "--levels", "4"}, {.at = {signal, 2}}).signal, signal);
    EXPECT_EQ(listing(), before);
  }
}

TEST_F(BadOutputTest, KilledRefineLeavesNoHalfOutput) {
  const std::string in = file("torus.obj", torusObj(16));
  EXPECT_EQ(run({"refine", in, path("out.obj"), "--levels", "4"}, {.at = {SIGKILL, 2}}).signal, SIGKILL);
  EXPECT_FALSE(listing().contains("out.obj"));
}

}  // namespace
}  // namespace honeycomb::Test
