#include <csignal>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <thread>

#include "workplace.h"

namespace honeycomb::Test {
namespace {

using testing::HasSubstr;

/// Open MPI keeps much until the process ends, which is no leak of ours.
const RunOptions kFour{.environment = {{"ASAN_OPTIONS", "detect_leaks=0"}}, .ranks = 4};

class MpiTest : public Workplace {
 protected:
  const std::string in_ = file("torus.obj", torusObj(16));

  std::vector<std::string> bake(const std::string& out, const std::string& frames, const std::string& levels) const {
    return {"bake", in_, path(out), "--cache", frames, "--levels", levels, "--threads", "1", "--json"};
  }
  static Outcome runRanks(const std::vector<std::string>& arguments) { return run(arguments, kFour); }
  static nlohmann::json finish(const std::vector<std::string>& arguments) {
    const Outcome outcome = runRanks(arguments);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return nlohmann::json::parse(outcome.out, nullptr, false);
  }
  /// How many have an entry in a journal: eight bytes each, of which some aren't zero, behind a header of 24.
  int framesIn(const std::string& journal) const {
    const std::string bytes = read(journal);
    int frames = 0;
    for (std::size_t i = 24; i + 8 <= bytes.size(); i += 8)
      frames += bytes.compare(i, 8, std::string(8, '\0')) == 0 ? 0 : 1;
    return frames;
  }
  /// The processes that another has started.
  static std::vector<pid_t> childrenOf(pid_t parent) {
    const std::string number = std::to_string(parent);
    std::ifstream list("/proc/" + number + "/task/" + number + "/children");
    return {std::istream_iterator<pid_t>(list), {}};
  }
};

TEST_F(MpiTest, FourRanksWriteTheFileOfOneProcess) {
  const std::string frames = bentCache("in.pc2", torusObj(16), 60);
  ASSERT_EQ(run(bake("one.pc2", frames, "3")).exitCode, 0);
  const auto summary = finish(bake("four.pc2", frames, "3"));
  EXPECT_EQ(summary.at("ranks"), 4);
  EXPECT_TRUE(read("four.pc2") == read("one.pc2"));
  EXPECT_EQ(listing().size(), 4U) << "nothing is left beside them";
}

TEST_F(MpiTest, SequencesAreSharedOutToo) {
  const std::string frames = bentCache("in.pc2", torusObj(16), 9);
  ASSERT_EQ(run(bake("one_%d.obj", frames, "1")).exitCode, 0);
  finish(bake("four_%d.obj", frames, "1"));
  for (int f = 0; f < 9; ++f) {
    const std::string name = "_" + std::to_string(f) + ".obj";
    EXPECT_TRUE(read("four" + name) == read("one" + name)) << name;
  }
}

// Each rank stops after some twenty frames, and again when mpirun has it go on: never are all frames there.
TEST_F(MpiTest, ARankThatDiesEndsTheJobAndTheNextOneGoesOn) {
  const std::string frames = bentCache("in.pc2", torusObj(16), 200);
  ASSERT_EQ(run(bake("one.mdd", frames, "3")).exitCode, 0);
  const std::vector<std::string> arguments = bake("four.mdd", frames, "3");
  RunOptions stopping = kFour;
  stopping.at = {SIGSTOP, 40};
  const pid_t mpirun = start(arguments, stopping);
  while (!hasEnded(mpirun) && framesIn(".four.mdd.journal") <= 10)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const std::vector<pid_t> ranks = childrenOf(mpirun);
  ASSERT_EQ(ranks.size(), 4U);
  kill(ranks[2], SIGKILL);
  EXPECT_NE(wait(mpirun).exitCode, 0);
  EXPECT_FALSE(listing().contains("four.mdd"));
  const auto summary = finish(arguments);
  EXPECT_GT(summary.at("frames_resumed"), 10);
  EXPECT_LT(summary.at("frames_resumed"), 200);
  EXPECT_TRUE(read("four.mdd") == read("one.mdd"));
}

TEST_F(MpiTest, TheFirstBadFrameIsNamedOnce) {
  const std::vector<float> good = bentFrame(torusObj(16), 1);
  std::vector<float> numbers;
  for (int f = 0; f < 40; ++f) numbers.insert(numbers.end(), good.begin(), good.end());
  numbers[31 * good.size()] = numbers[32 * good.size()] = std::numeric_limits<float>::quiet_NaN();
  const std::string frames = cache("in.pc2", 256, 40, numbers);
  const auto before = listing();
  const Outcome outcome = runRanks(bake("four.pc2", frames, "2"));
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("vertex 0 of frame 31"));
  EXPECT_EQ(outcome.err.find("error: "), outcome.err.rfind("error: ")) << outcome.err;
  EXPECT_EQ(listing(), before);
}

}  // namespace
}  // namespace honeycomb::Test
