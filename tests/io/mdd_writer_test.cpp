#include "io/mdd_writer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "io/stream_writer.h"
#include "tests/io/files.h"

namespace honeycomb::Io::Test {
namespace {

Result<StreamWriter> createMdd(const std::filesystem::path& path, const FrameInfo& info) {
  return mddLayout(path.string(), info).and_then([&](const auto& layout) {
    return StreamWriter::create(path, layout);
  });
}

TEST(MddWriter, WritesBigEndianCountsTimesAndFrames) {
  const TemporaryFolder folder;
  Result<StreamWriter> writer = createMdd(folder / "a.mdd", {1, 2, 0.5F, 0.25F, 4});
  ASSERT_TRUE(writer) << writer.error().message;
  ASSERT_TRUE(writer->write(std::vector<float>{1, -2, 0}));
  ASSERT_TRUE(writer->write(std::vector<float>{0, 0.5F, 3}));
  ASSERT_TRUE(writer->finish());
  using namespace std::string_literals;
  EXPECT_EQ(readBytes(folder / "a.mdd"),
            "\0\0\0\2\0\0\0\1"s        // frames, points
            "\x3F\0\0\0\x3F\x40\0\0"s  // 0.5 s, 0.75 s
            "\x3F\x80\0\0\xC0\0\0\0\0\0\0\0"s
            "\0\0\0\0\x3F\0\0\0\x40\x40\0\0"s);
}

TEST(MddWriter, RefusesTimesThatDontAscend) {
  for (const float rate : {0.0F, -1.0F, NAN, INFINITY}) {
    const auto layout = mddLayout("a.mdd", {1, 2, 0, rate, 0});
    ASSERT_FALSE(layout) << rate;
    EXPECT_EQ(layout.error().code, ErrorCode::invalidOption);
    EXPECT_TRUE(layout.error().message.starts_with("a.mdd: ")) << layout.error().message;
  }
}

TEST(MddWriter, RefusesEmptyCaches) {
  EXPECT_EQ(mddLayout("a.mdd", {0, 3, 0, 1, 0}).error().message,
            "a.mdd: an MDD cache of 0 points and 3 frames cannot be; give one or more of each");
  EXPECT_FALSE(mddLayout("a.mdd", {3, 0, 0, 1, 0}));
}

}  // namespace
}  // namespace honeycomb::Io::Test
