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

TEST(FrameNames, OtherNamesAreNoPatterns) {
  for (const std::string name :
       {"out.obj", "100%.obj", "%s.obj", "%04d_%04d.obj", "%", "%0", "%-4d", "%19d", "a_%d/b.obj"})
    EXPECT_EQ(nameOf(name, 7), "none") << name;
}

}  // namespace
}  // namespace honeycomb::Io::Test
