#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "workplace.h"

namespace honeycomb::Test {
namespace {

using testing::HasSubstr;

/// 9,216 vertices a frame at level 3.
class BakeResumeTest : public Workplace {
 protected:
#ifdef HONEYCOMB_SANITIZED
  static constexpr int kFrames = 50;  // the program is several times slower
#else
  static constexpr int kFrames = 150;
#endif
  static constexpr std::uintmax_t kBytes = std::uintmax_t{kFrames} * 12 * 9216;
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
  /// Kills it when its unfinished file has grown to `bytes`; false when it was over before.
  bool killAt(const std::string& out, std::uintmax_t bytes, int signal = SIGKILL,
              const std::vector<std::string>& more = {}) const {
    const pid_t child = start(bake(out, more));
    std::error_code error;
    const auto size = [&] { return std::filesystem::file_size(path("." + out + ".part"), error); };
    siginfo_t ended{};
    const auto running = [&] {
      return waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 && ended.si_pid == 0;
    };
    while (running() && (size() < bytes || error)) std::this_thread::sleep_for(std::chrono::microseconds(100));
    kill(child, signal);
    return wait(child).signal == signal;
  }
  /// Kills it when some frames but not all are there.
  void stopHalfWay(const std::string& out, int signal = SIGKILL, const std::vector<std::string>& more = {}) const {
    ASSERT_TRUE(killAt(out, kBytes / 3, signal, more)) << "it was over already";
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
  int killed = 0;
  for (std::uintmax_t moment = 0; moment < 8; ++moment) {
    killed += killAt("out.pc2", kBytes * moment / 8) ? 1 : 0;
    finish(bake("out.pc2"));
    ASSERT_TRUE(read("out.pc2") == whole) << "moment " << moment;
    std::filesystem::remove(path("out.pc2"));
  }
  EXPECT_GE(killed, 4);
  EXPECT_EQ(listing(), (std::set<std::string>{"in.pc2", "torus.obj", "whole.pc2"}));
}

TEST_F(BakeResumeTest, KilledAgainAndAgainItComesToItsEnd) {
  const std::string whole = uninterrupted(".mdd");
  int killed = 0;
  for (std::uintmax_t eighths = 1; eighths < 8; ++eighths) killed += killAt("out.mdd", kBytes * eighths / 8) ? 1 : 0;
  EXPECT_GE(killed, 3);
  finish(bake("out.mdd"));
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
  const Outcome outcome = run(bake("out.pc2"), {{}, 5'000'000});
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_TRUE(isOneErrorLine(outcome.err)) << outcome.err;
  EXPECT_THAT(outcome.err, testing::AllOf(HasSubstr("File too large"), HasSubstr("frames are whole"),
                                          HasSubstr("the same command goes on")));
  EXPECT_GT(finish(bake("out.pc2")).at("frames_resumed"), 10);
  EXPECT_TRUE(read("out.pc2") == uninterrupted(".pc2"));
}

TEST_F(BakeResumeTest, TwoBakesOfOneFileDontMix) {
  const pid_t child = start(bake("out.pc2"));
  while (!listing().contains(".out.pc2.part")) std::this_thread::sleep_for(std::chrono::microseconds(100));
  kill(child, SIGSTOP);
  const Outcome second = run(bake("out.pc2"));
  kill(child, SIGCONT);
  EXPECT_EQ(wait(child).exitCode, 0);
  EXPECT_EQ(second.exitCode, 1);
  EXPECT_TRUE(isOneErrorLine(second.err)) << second.err;
  EXPECT_THAT(second.err, HasSubstr("out.pc2: is being written by another run"));
  EXPECT_TRUE(read("out.pc2") == uninterrupted(".pc2"));
}

TEST_F(BakeResumeTest, SequencesGoOnBehindTheFilesThatAreThere) {
  const std::vector<std::string> arguments = bake("out_%03d.obj", {"--frames", "5:45"});
  finish(bake("whole_%03d.obj", {"--frames", "5:45"}));
  const pid_t child = start(arguments);
  while (!std::filesystem::exists(path("out_020.obj"))) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  kill(child, SIGKILL);
  ASSERT_EQ(wait(child).signal, SIGKILL);
  const auto before = std::filesystem::last_write_time(path("out_007.obj"));
  EXPECT_GT(finish(arguments).at("frames_resumed"), 10);
  EXPECT_EQ(std::filesystem::last_write_time(path("out_007.obj")), before);
  for (int f = 5; f < 45; ++f) {
    const std::string number = "_" + std::string(f < 10 ? "00" : "0") + std::to_string(f) + ".obj";
    EXPECT_TRUE(read("out" + number) == read("whole" + number)) << number;
  }
  EXPECT_EQ(listing().size(), 2U + 2 * 40) << "nothing else is left";
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
