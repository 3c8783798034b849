#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>

#include "workplace.h"

namespace honeycomb::Test {
namespace {

using testing::HasSubstr;

/// 9,216 vertices a frame at level 3. Writes: three to begin, then a frame and its entry in the journal in turn.
class BakeResumeTest : public Workplace {
 protected:
  static constexpr int kFrames = 40;
  static constexpr int kLastWrite = 3 + 2 * kFrames;
  static constexpr int kHalfWay = kLastWrite / 2;
  const std::string in_ = file("torus.obj", torusObj(16));
  const std::string frames_ = bentCache("in.pc2", torusObj(16), kFrames);

  std::vector<std::string> bake(const std::string& out, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"bake",     in_, path(out), "--cache",   frames_,
                                       "--levels", "3", "--json",  "--threads", "2"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  nlohmann::json finish(const std::vector<std::string>& arguments) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out);
  }
  /// Stops it at one of its writes.
  void stopAt(const SignalAtWrite& at, const std::vector<std::string>& arguments) const {
    const Outcome outcome = run(arguments, {.at = at});
    ASSERT_EQ(outcome.signal, at.signal) << outcome.err << "at write " << at.write;
  }
  /// Stops it when some frames but not all are there.
  void stopHalfWay(const std::string& out, int signal = SIGKILL, const std::vector<std::string>& more = {}) const {
    stopAt({signal, kHalfWay}, bake(out, more));
    ASSERT_TRUE(listing().contains("." + out + ".journal"));
    ASSERT_FALSE(listing().contains(out));
  }
  std::string uninterrupted(const std::string& extension) const {
    finish(bake("whole" + extension));
    return read("whole" + extension);
  }
};

TEST_F(BakeResumeTest, KilledAtAnyMomentAndRunAgainItIsTheUninterruptedFile) {
  const std::string whole = uninterrupted(".pc2");
  for (const int write : {1, 2, 3, 4, 5, 6, 7, kHalfWay, kHalfWay + 1, kLastWrite - 1, kLastWrite}) {
    stopAt({SIGKILL, write}, bake("out.pc2"));
    finish(bake("out.pc2"));
    ASSERT_TRUE(read("out.pc2") == whole) << "write " << write;
    std::filesystem::remove(path("out.pc2"));
  }
  EXPECT_EQ(listing(), (std::set<std::string>{"in.pc2", "torus.obj", "whole.pc2"}));
}

TEST_F(BakeResumeTest, KilledAgainAndAgainItComesToItsEnd) {
  const std::string whole = uninterrupted(".mdd");
  for (int i = 0; i < 3; ++i) stopAt({SIGKILL, 20}, bake("out.mdd"));
  EXPECT_GT(finish(bake("out.mdd")).at("frames_resumed"), 15) << "of each run's eight";
  EXPECT_TRUE(read("out.mdd") == whole);
}

TEST_F(BakeResumeTest, GlbGoesOnToo) {
  stopHalfWay("out.glb");
  EXPECT_GT(finish(bake("out.glb")).at("frames_resumed"), 10);
  EXPECT_TRUE(read("out.glb") == uninterrupted(".glb"));
}

TEST_F(BakeResumeTest, FinishedFramesAreNotBakedAgain) {
  stopHalfWay("out.pc2");
  const auto summary = finish(bake("out.pc2"));
  EXPECT_GT(summary.at("frames_resumed"), 10);
  EXPECT_LT(summary.at("frames_resumed"), kFrames);
  EXPECT_TRUE(read("out.pc2") == uninterrupted(".pc2"));
}

TEST_F(BakeResumeTest, AnotherBackendGoesOn) {
  stopHalfWay("out.pc2");
  EXPECT_GT(finish(bake("out.pc2", {"--backend", "serial"})).at("frames_resumed"), 10);
  EXPECT_TRUE(read("out.pc2") == uninterrupted(".pc2"));
}

TEST_F(BakeResumeTest, InterruptedItKeepsWhatItHas) {
  for (const int signal : {SIGINT, SIGTERM}) {
    stopHalfWay("out.pc2", signal);
    EXPECT_GT(finish(bake("out.pc2")).at("frames_resumed"), 10);
    EXPECT_TRUE(read("out.pc2") == uninterrupted(".pc2"));
    std::filesystem::remove(path("out.pc2"));
  }
}

TEST_F(BakeResumeTest, AnotherCommandStartsAnew) {
  const std::string whole = uninterrupted(".pc2");
  for (const std::vector<std::string>& other :
       {std::vector<std::string>{"--tension", "sqrt3"}, {"--frames", "1:"}, {"--order", "spatial"}}) {
    stopHalfWay("out.pc2", SIGKILL, other);
    EXPECT_EQ(finish(bake("out.pc2")).at("frames_resumed"), 0) << other[0];
    EXPECT_TRUE(read("out.pc2") == whole) << other[0];
    std::filesystem::remove(path("out.pc2"));
  }
}

TEST_F(BakeResumeTest, AnotherAnimationStartsAnew) {
  stopHalfWay("out.pc2");
  std::fstream cache(frames_, std::ios::in | std::ios::out | std::ios::binary);
  cache.seekp(-4, std::ios::end);
  cache.write("\0\0\0\x40", 4);  // the last coordinate is 2 now
  cache.close();
  EXPECT_EQ(finish(bake("out.pc2")).at("frames_resumed"), 0);
  EXPECT_TRUE(read("out.pc2") == uninterrupted(".pc2"));
}

TEST_F(BakeResumeTest, RestartIgnoresWhatIsThere) {
  stopHalfWay("out.pc2");
  EXPECT_EQ(finish(bake("out.pc2", {"--restart"})).at("frames_resumed"), 0);
  EXPECT_TRUE(read("out.pc2") == uninterrupted(".pc2"));
}

TEST_F(BakeResumeTest, FramesThatAreNotOnTheDiskAfterAllAreBakedAgain) {
  stopHalfWay("out.pc2");
  std::fstream part(path(".out.pc2.part"), std::ios::in | std::ios::out | std::ios::binary);
  part.seekp(32 + 3 * 12 * 9216 + 777);
  part.write("lost", 4);
  part.close();
  EXPECT_GT(finish(bake("out.pc2")).at("frames_resumed"), 10);
  EXPECT_TRUE(read("out.pc2") == uninterrupted(".pc2"));
}

TEST_F(BakeResumeTest, DamagedJournalsStartAnew) {
  for (const std::string journal : {"HONEYJ1\n", "garbage that is long enough to be a header of something else"}) {
    stopHalfWay("out.pc2");
    file(".out.pc2.journal", journal);
    EXPECT_EQ(finish(bake("out.pc2")).at("frames_resumed"), 0);
    EXPECT_TRUE(read("out.pc2") == uninterrupted(".pc2"));
    std::filesystem::remove(path("out.pc2"));
  }
}

TEST_F(BakeResumeTest, FullDiskSaysThatItGoesOn) {
  const Outcome outcome = run(bake("out.pc2"), {.fileSizeLimit = 3'000'000});
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_TRUE(isOneErrorLine(outcome.err)) << outcome.err;
  EXPECT_THAT(outcome.err, testing::AllOf(HasSubstr("File too large"), HasSubstr("frames are whole"),
                                          HasSubstr("the same command goes on")));
  EXPECT_GT(finish(bake("out.pc2")).at("frames_resumed"), 10);
  EXPECT_TRUE(read("out.pc2") == uninterrupted(".pc2"));
}

TEST_F(BakeResumeTest, TwoBakesOfOneFileDontMix) {
  const pid_t child = start(bake("out.pc2"), {.at = {SIGSTOP, kLastWrite - 10}});
  ASSERT_TRUE(waitUntilStopped(child));
  const Outcome second = run(bake("out.pc2"));
  EXPECT_EQ(continueToTheEnd(child).exitCode, 0);
  EXPECT_EQ(second.exitCode, 1);
  EXPECT_TRUE(isOneErrorLine(second.err)) << second.err;
  EXPECT_THAT(second.err, HasSubstr("out.pc2: is being written by another run"));
  EXPECT_TRUE(read("out.pc2") == uninterrupted(".pc2"));
}

// On one thread, frames are written in their order.
TEST_F(BakeResumeTest, SequencesGoOnBehindTheFilesThatAreThere) {
  const std::vector<std::string> serial{"--frames", "5:35", "--backend", "serial"};
  finish(bake("whole_%03d.obj", serial));
  stopAt({SIGKILL, 50}, bake("out_%03d.obj", serial));
  ASSERT_TRUE(listing().contains("out_015.obj"));
  ASSERT_FALSE(listing().contains("out_034.obj"));
  const auto before = std::filesystem::last_write_time(path("out_007.obj"));
  EXPECT_GT(finish(bake("out_%03d.obj", serial)).at("frames_resumed"), 10);
  EXPECT_EQ(std::filesystem::last_write_time(path("out_007.obj")), before);
  for (int f = 5; f < 35; ++f) {
    const std::string number = "_" + std::string(f < 10 ? "00" : "0") + std::to_string(f) + ".obj";
    EXPECT_TRUE(read("out" + number) == read("whole" + number)) << number;
  }
  EXPECT_EQ(listing().size(), 2U + 2 * 30) << "nothing else is left";
}

TEST_F(BakeResumeTest, MemoryIsThatOfAFewFrames) {
  const std::string many = bentCache("many.pc2", torusObj(16), 1000);
  const auto memoryOf = [&](const std::string& range) {
    const Outcome outcome = run({"bake", in_, path("out.pc2"), "--cache", many, "--levels", "3", "--frames", range});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    return outcome.mostMemory;
  };
  const std::int64_t few = memoryOf("0:20"), all = memoryOf(":");
  EXPECT_EQ(std::filesystem::file_size(path("out.pc2")), 32U + 1000U * 12 * 9216);  // 110 MB
  EXPECT_LT(all, few + 20'000'000);
}

}  // namespace
}  // namespace honeycomb::Test
