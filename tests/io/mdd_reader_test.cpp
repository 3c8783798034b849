#include <gmock/gmock.h>

#include <bit>
#include <cmath>
#include <string>
#include <vector>

#include "io/mdd.h"
#include "tests/io/files.h"

namespace honeycomb::Io::Test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string bigEndianBytes(std::uint32_t value) {
  return {static_cast<char>(value >> 24U), static_cast<char>(value >> 16U), static_cast<char>(value >> 8U),
          static_cast<char>(value)};
}

/// A cache byte by byte, independent of the library's own.
std::string mddBytes(std::uint32_t frames, std::uint32_t points, const std::vector<float>& floats) {
  std::string bytes = bigEndianBytes(frames) + bigEndianBytes(points);
  for (const float value : floats) bytes += bigEndianBytes(std::bit_cast<std::uint32_t>(value));
  return bytes;
}

/// Two frames at 0.5 and 0.75 seconds of one point.
const std::vector<float> kMddNumbers{0.5F, 0.75F, 1, 2, 3, -4, 5.5F, 6};

std::string mddRefusal(const std::string& bytes) {
  const TemporaryFolder folder;
  writeBytes(folder / "a.mdd", bytes);
  const Result<MddReader> reader = MddReader::open(folder / "a.mdd");
  return reader ? "accepted" : reader.error().message.substr(folder.path().string().size() + 1);
}

TEST(MddReader, ReadsTimesAndFrames) {
  const TemporaryFolder folder;
  writeBytes(folder / "a.mdd", mddBytes(2, 1, kMddNumbers) + "passed over");
  const Result<MddReader> reader = MddReader::open(folder / "a.mdd");
  ASSERT_TRUE(reader) << reader.error().message;
  EXPECT_EQ(reader->info().frameCount, 2);
  EXPECT_EQ(reader->info().pointCount, 1);
  EXPECT_EQ(reader->info().start, 0.5F);
  EXPECT_EQ(reader->info().rate, 0.25F);
  EXPECT_EQ(reader->info().framesPerSecond, 4.0F);
  std::vector<float> storage;
  EXPECT_THAT(*reader->frame(1, storage), ElementsAre(-4, 5.5F, 6));
  EXPECT_THAT(*reader->frame(0, storage), ElementsAre(1, 2, 3));
  EXPECT_THAT(reader->frame(2, storage).error().message, HasSubstr("has no frame 2; name one of 0 to 1"));
}

TEST(MddReader, RefusesWhatIsCutOff) {
  const std::string whole = mddBytes(2, 1, kMddNumbers);
  EXPECT_EQ(mddRefusal(""), "a.mdd: is empty; give an MDD point cache");
  EXPECT_THAT(mddRefusal(whole.substr(0, 7)), HasSubstr("ends within the header"));
  EXPECT_THAT(mddRefusal(whole.substr(0, 15)), HasSubstr("cut off within the times of its 2 frames"));
  EXPECT_THAT(mddRefusal(whole.substr(0, whole.size() - 1)), HasSubstr("cut off within frame 1"));
  EXPECT_THAT(mddRefusal(mddBytes(0x7FFFFFFF, 0x7FFFFFFF, kMddNumbers)), HasSubstr("cut off"));
  EXPECT_THAT(mddRefusal(mddBytes(1, 0x7FFFFFFF, kMddNumbers)), HasSubstr("cut off within frame 0"));
  EXPECT_THAT(mddRefusal(mddBytes(0xFFFFFFFF, 1, kMddNumbers)), HasSubstr("has -1 frames"));
}

TEST(MddReader, NotANumberIsAnErrorThatSaysWhere) {
  std::vector<float> numbers = kMddNumbers;
  numbers[1] = NAN;
  EXPECT_THAT(mddRefusal(mddBytes(2, 1, numbers)), HasSubstr("the time of frame 1 (counted from 0) is nan"));
  numbers = kMddNumbers;
  numbers[6] = INFINITY;
  const TemporaryFolder folder;
  writeBytes(folder / "a.mdd", mddBytes(2, 1, numbers));
  const Result<MddReader> reader = MddReader::open(folder / "a.mdd");
  ASSERT_TRUE(reader);
  std::vector<float> storage;
  EXPECT_TRUE(reader->frame(0, storage));
  EXPECT_THAT(reader->frame(1, storage).error().message, HasSubstr("vertex 0 of frame 1 (both counted from 0)"));
}

}  // namespace
}  // namespace honeycomb::Io::Test
