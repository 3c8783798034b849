#include "io/frame_names.h"

#include <gtest/gtest.h>

namespace honeycomb::Io::Test {
namespace {

std::string nameOf(const std::string& pattern, std::int64_t frame) {
  const auto names = FrameNames::parse(pattern);
  return names ? (*names)(frame).string() : "none";
}

TEST(FrameNames, PadTheNumberWithZeros) {
  EXPECT_EQ(nameOf("a/out_%04d.obj", 7), "a/out_0007.obj");
  EXPECT_EQ(nameOf("out_%4d.obj", 7), "out_0007.obj");
  EXPECT_EQ(nameOf("out_%d.obj", 7), "out_7.obj");
  EXPECT_EQ(nameOf("%02d", 123), "123");
}

TEST(FrameNames, KnowTheFrameOfAName) {
  const auto four = FrameNames::parse("a/out_%04d.obj"), any = FrameNames::parse("%d");
  EXPECT_EQ(four->frameOf("out_0007.obj"), 7);
  EXPECT_EQ(four->frameOf("out_12345.obj"), 12345);
  EXPECT_EQ(any->frameOf("0"), 0);
  for (const char* name :
       {"out_7.obj", "out_.obj", "out_-007.obj", "out_0007.ply", "out_0007.obj.obj", "xout_0007.obj"})
    EXPECT_FALSE(four->frameOf(name)) << name;
  EXPECT_FALSE(any->frameOf("99999999999999999999"));
}

TEST(FrameNames, OtherNamesAreNoPatterns) {
  for (const std::string name :
       {"out.obj", "100%.obj", "%s.obj", "%04d_%04d.obj", "%", "%0", "%-4d", "%19d", "a_%d/b.obj"})
    EXPECT_EQ(nameOf(name, 7), "none") << name;
}

}  // namespace
}  // namespace honeycomb::Io::Test
