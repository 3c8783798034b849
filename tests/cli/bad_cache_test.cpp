#include <limits>

#include "workplace.h"

namespace honeycomb::Test {
namespace {

using testing::HasSubstr;

class BadCacheTest : public Workplace {
 protected:
  std::vector<std::string> bake(const std::string& frames, std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments{"bake", file("cube.obj", cubeObj()), path("out.pc2"), "--cache", frames};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  std::string cubeCache(int frames) const { return bentCache("in.pc2", cubeObj(), frames); }
};

TEST_F(BadCacheTest, TruncatedIsRefusedNamingTheFrame) {
  const std::string in = cubeCache(3);
  std::filesystem::resize_file(in, 32 + 2 * 96 + 40);
  EXPECT_REFUSED(bake(in), HasSubstr(in), HasSubstr("frame 2"));
}

TEST_F(BadCacheTest, AnotherPointCountIsRefusedNamingBoth) {
  const std::string in = cache("in.pc2", 9, 1, std::vector<float>(27, 0.0F));
  EXPECT_REFUSED(bake(in), HasSubstr(in), HasSubstr("9 points"), HasSubstr("8 vertices"));
}

TEST_F(BadCacheTest, NaNIsRefusedNamingFrameAndVertex) {
  std::vector<float> numbers(5 * 24, 0.5F);
  numbers[3 * 24 + 5 * 3 + 1] = std::numeric_limits<float>::quiet_NaN();
  const std::string in = cache("in.pc2", 8, 5, numbers);
  EXPECT_REFUSED(bake(in), HasSubstr(in), HasSubstr("vertex 5 of frame 3"));
  EXPECT_REFUSED(bake(in, {"--backend", "serial", "--mesh", path("mesh.obj")}), HasSubstr("vertex 5 of frame 3"));
  EXPECT_EQ(run(bake(in, {"--frames", "0:3"})).exitCode, 0);
}

TEST_F(BadCacheTest, TheFirstOfSeveralBadFramesIsNamed) {
  std::vector<float> numbers(6 * 24, 0.5F);
  numbers[2 * 24] = numbers[3 * 24 + 7] = std::numeric_limits<float>::infinity();
  EXPECT_REFUSED(bake(cache("in.pc2", 8, 6, numbers), {"--threads", "4"}), HasSubstr("vertex 0 of frame 2"));
}

TEST_F(BadCacheTest, OverflowIsRefusedNamingTheFrame) {
  std::vector<float> numbers(2 * 24, 0.5F);
  for (std::size_t i = 24; i < 48; ++i) numbers[i] = 3e38F;
  EXPECT_REFUSED(bake(cache("in.pc2", 8, 2, numbers)), HasSubstr("frame 1"), HasSubstr("overflows"));
}

TEST_F(BadCacheTest, GarbageIsRefused) {
  EXPECT_REFUSED(bake(file("in.pc2", "not a point cache, though long enough for a header")), HasSubstr("in.pc2"));
  EXPECT_REFUSED(bake(file("in.pc2", "")), HasSubstr("in.pc2"));
  EXPECT_REFUSED(bake(path("none.pc2")), HasSubstr("none.pc2"));
}

TEST_F(BadCacheTest, NoCacheAndUnknownFormatsAreRefused) {
  const std::string in = file("cube.obj", cubeObj());
  EXPECT_REFUSED((std::vector<std::string>{"bake", in, path("out.pc2")}), HasSubstr("--cache"));
  EXPECT_REFUSED((std::vector<std::string>{"bake", in, path("out.pc2"), "--cache", file("in.abc", "x")}),
                 HasSubstr(".pc2, .mdd"));
  EXPECT_REFUSED((std::vector<std::string>{"bake", in, path("out.abc"), "--cache", cubeCache(1)}), HasSubstr(".pc2"),
                 HasSubstr(".mdd"), HasSubstr("frame_%04d.obj"));
  EXPECT_REFUSED((std::vector<std::string>{"bake", in, path("out_%d.xyz"), "--cache", cubeCache(1)}),
                 HasSubstr(".obj"));
}

TEST_F(BadCacheTest, CentralControlVerticesThatDontFitTheAnimationAreRefused) {
  const auto with = [this](const std::string& central) {
    return bake(cubeCache(2), {"--scheme", "zhang-wang", "--ccv", central});
  };
  EXPECT_REFUSED(with(file("six.obj", "v 0 0 0\n")), HasSubstr("six.obj: holds one pose"), HasSubstr(".pc2"),
                 HasSubstr("--ccv-offset"));
  EXPECT_REFUSED(with(cache("seven.pc2", 7, 2, std::vector<float>(42))), HasSubstr("seven.pc2: has 7 points"),
                 HasSubstr("6 faces"));
  EXPECT_REFUSED(with(cache("long.pc2", 6, 3, std::vector<float>(54))), HasSubstr("long.pc2: has 3 frames"),
                 HasSubstr("has 2"));
  std::vector<float> numbers(36, 0.5F);
  numbers[20] = std::numeric_limits<float>::infinity();
  EXPECT_REFUSED(with(cache("infinite.pc2", 6, 2, numbers)), HasSubstr("infinite.pc2"),
                 HasSubstr("vertex 0 of frame 1"));
}

TEST_F(BadCacheTest, FrameRangesOutsideTheCacheAreRefused) {
  const std::string in = cubeCache(4);
  for (const std::string range : {"4:5", "2:2", "3:1", "0:5", "x", "1", "-1:2", "1:2:3"})
    EXPECT_REFUSED(bake(in, {"--frames", range}), HasSubstr("--frames " + range), HasSubstr("a:b"));
}

}  // namespace
}  // namespace honeycomb::Test
