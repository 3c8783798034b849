#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "io/pc2.h"
#include "tests/io/files.h"
#include "tests/io/pc2_bytes.h"

namespace honeycomb::Io::Test {
namespace {

using testing::ElementsAre;
constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();
const std::vector<float> kTwoFrames{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};  // of two points

/// The error, its message without the folder, of opening a file of these bytes.
Error refusal(const std::string& bytes) {
  const TemporaryFolder folder;
  writeBytes(folder / "a.pc2", bytes);
  const Result<Pc2Reader> reader = Pc2Reader::open(folder / "a.pc2");
  if (reader) {
    ADD_FAILURE() << "accepted";
    return {};
  }
  Error error = reader.error();
  error.message = error.message.substr(folder.path().string().size() + 1);
  return error;
}

TEST(Pc2Reader, ReadsHeaderAndFrames) {
  const TemporaryFolder folder;
  writeBytes(folder / "a.pc2", pc2Header(2, 2) + bytesOf(kTwoFrames));
  Result<Pc2Reader> opened = Pc2Reader::open(folder / "a.pc2");
  ASSERT_TRUE(opened) << opened.error().message;
  const Pc2Reader reader = *std::move(opened);
  EXPECT_EQ(reader.info().pointCount, 2);
  EXPECT_EQ(reader.info().frameCount, 2);
  EXPECT_EQ(reader.info().start, 0.5F);
  EXPECT_EQ(reader.info().rate, 0.25F);
  EXPECT_THAT(*reader.frame(1), ElementsAre(6, 7, 8, 9, 10, 11));
  EXPECT_THAT(*reader.frame(0), ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST(Pc2Reader, PassesOverBytesBehindTheLastFrame) {
  const TemporaryFolder folder;
  writeBytes(folder / "a.pc2", pc2Header(2, 1) + bytesOf(kTwoFrames) + "x");
  const Result<Pc2Reader> reader = Pc2Reader::open(folder / "a.pc2");
  ASSERT_TRUE(reader) << reader.error().message;
  EXPECT_THAT(*reader->frame(0), ElementsAre(0, 1, 2, 3, 4, 5));
  EXPECT_FALSE(reader->frame(1));
}

TEST(Pc2Reader, NamesTheFramesThereAre) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.pc2").string();
  writeBytes(path, pc2Header(2, 2) + bytesOf(kTwoFrames));
  const Result<Pc2Reader> reader = Pc2Reader::open(path);
  ASSERT_TRUE(reader) << reader.error().message;
  for (const std::int32_t f : {-1, 2, kMost}) {
    const auto frame = reader->frame(f);
    ASSERT_FALSE(frame);
    EXPECT_EQ(frame.error().code, ErrorCode::invalidOption);
    EXPECT_EQ(frame.error().message, path + ": has no frame " + std::to_string(f) + "; name one of 0 to 1");
  }
}

TEST(Pc2Reader, NanAndInfinityNameFrameAndVertex) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.pc2").string();
  std::vector<float> points = kTwoFrames;
  points[10] = -INFINITY;
  writeBytes(path, pc2Header(2, 2) + bytesOf(points));
  const Result<Pc2Reader> reader = Pc2Reader::open(path);
  ASSERT_TRUE(reader) << reader.error().message;
  EXPECT_TRUE(reader->frame(0));
  const auto frame = reader->frame(1);
  ASSERT_FALSE(frame);
  EXPECT_EQ(frame.error().code, ErrorCode::invalidPositions);
  EXPECT_EQ(frame.error().element, 1);
  EXPECT_EQ(frame.error().message,
            path + ": vertex 1 of frame 1 (both counted from 0) has the coordinate -inf; give it a finite position");
}

TEST(Pc2Reader, FindsNanAtEveryPlace) {
  for (std::size_t place = 0; place < kTwoFrames.size(); ++place) {
    const TemporaryFolder folder;
    std::vector<float> points = kTwoFrames;
    points[place] = NAN;
    writeBytes(folder / "a.pc2", pc2Header(4, 1) + bytesOf(points));
    const Result<Pc2Reader> reader = Pc2Reader::open(folder / "a.pc2");
    ASSERT_TRUE(reader) << reader.error().message;
    const auto frame = reader->frame(0);
    ASSERT_FALSE(frame) << place;
    EXPECT_EQ(frame.error().element, static_cast<std::int64_t>(place / 3));
  }
}

TEST(Pc2Reader, LargestAndSmallestNumbersAreFinite) {
  const TemporaryFolder folder;
  using Limits = std::numeric_limits<float>;
  const std::vector<float> points{Limits::max(), Limits::lowest(), Limits::denorm_min()};
  writeBytes(folder / "a.pc2", pc2Header(1, 1) + bytesOf(points));
  const Result<Pc2Reader> reader = Pc2Reader::open(folder / "a.pc2");
  ASSERT_TRUE(reader) << reader.error().message;
  EXPECT_TRUE(reader->frame(0));
}

TEST(Pc2Reader, RefusesAnotherKindOfFile) {
  EXPECT_EQ(refusal("").message, "a.pc2: is empty; give a PC2 point cache");
  const std::string expected = "a.pc2: does not begin with POINTCACHE2; give a PC2 point cache";
  EXPECT_EQ(refusal("POINTCACHE2").message, expected);
  EXPECT_EQ(refusal("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").message, expected);
  EXPECT_EQ(refusal(pc2Header(1, 1).substr(0, 31)).message, "a.pc2: ends within the header; export the cache again");
  EXPECT_EQ(refusal("").code, ErrorCode::invalidFile);
}

TEST(Pc2Reader, RefusesOtherVersionsAndEmptyCaches) {
  const std::string points = bytesOf(kTwoFrames);
  EXPECT_EQ(refusal(pc2Header(2, 2, 2) + points).message,
            "a.pc2: is PC2 version 2, only version 1 is known; export it as that");
  EXPECT_EQ(refusal(pc2Header(0, 2) + points).message, "a.pc2: has 0 points; export a cache of a mesh with vertices");
  EXPECT_EQ(refusal(pc2Header(-5, 2) + points).message, "a.pc2: has -5 points; export a cache of a mesh with vertices");
  EXPECT_EQ(refusal(pc2Header(2, 0) + points).message, "a.pc2: has 0 frames; export at least one frame");
  EXPECT_EQ(refusal(pc2Header(2, -1) + points).message, "a.pc2: has -1 frames; export at least one frame");
}

TEST(Pc2Reader, NamesTheFirstFrameThatIsCut) {
  const std::string whole = pc2Header(2, 2) + bytesOf(kTwoFrames);
  const auto expected = [](int frame) {
    return "a.pc2: is cut off within frame " + std::to_string(frame) +
           " (counted from 0) of 2 frames of 2 points; export the cache again or copy it whole";
  };
  EXPECT_EQ(refusal(whole.substr(0, whole.size() - 1)).message, expected(1));
  EXPECT_EQ(refusal(whole.substr(0, 32 + 24)).message, expected(1));
  EXPECT_EQ(refusal(whole.substr(0, 32 + 23)).message, expected(0));
  EXPECT_EQ(refusal(whole.substr(0, 32)).message, expected(0));
  EXPECT_EQ(refusal(whole.substr(0, 32 + 24)).element, 1);
}

TEST(Pc2Reader, HostileCountsDoNotOverflow) {
  EXPECT_EQ(refusal(pc2Header(kMost, kMost) + bytesOf(kTwoFrames)).element, 0);
  // 12 bytes x 842443544 x 1824726041 are a multiple of 2^64 plus 32, 12 bytes x 357913942 are 2^32 + 8: less than the
  // file has once wrapped.
  EXPECT_EQ(refusal(pc2Header(842443544, 1824726041) + bytesOf(kTwoFrames)).element, 0);
  EXPECT_EQ(refusal(pc2Header(357913942, 1) + bytesOf(kTwoFrames)).element, 0);
  EXPECT_EQ(refusal(pc2Header(1, kMost) + bytesOf(kTwoFrames)).element, 4);
}

TEST(Pc2Reader, RefusesFilesThatAreNotThere) {
  const TemporaryFolder folder;
  const std::string path = (folder / "no.pc2").string();
  const Result<Pc2Reader> reader = Pc2Reader::open(path);
  ASSERT_FALSE(reader);
  EXPECT_EQ(reader.error().code, ErrorCode::unreadable);
  EXPECT_EQ(reader.error().message, path + ": cannot be read: No such file or directory; check the path");
}

TEST(Pc2Reader, ReadsPastFourGigabytes) {
  const TemporaryFolder folder;
  constexpr std::int32_t kPoints = 1000;
  constexpr std::int32_t kFrames = 400000;
  writeBytes(folder / "a.pc2", pc2Header(kPoints, kFrames));
  std::filesystem::resize_file(folder / "a.pc2", 32 + std::uintmax_t{12} * kPoints * kFrames);  // 4.8 GB, all a hole
  {
    std::fstream file(folder / "a.pc2", std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(-4, std::ios::end);
    file.write(bytesOf(std::vector<float>{42}).data(), 4);
  }
  const Result<Pc2Reader> reader = Pc2Reader::open(folder / "a.pc2");
  ASSERT_TRUE(reader) << reader.error().message;
  EXPECT_EQ(reader->frame(kFrames - 1)->back(), 42.0F);
  EXPECT_EQ(reader->frame(kFrames - 2)->back(), 0.0F);
}

/// Resident pages of mapped files, in bytes.
std::int64_t residentFileBytes() {
  std::int64_t total = 0;
  std::int64_t resident = 0;
  std::int64_t shared = 0;
  std::ifstream("/proc/self/statm") >> total >> resident >> shared;
  return shared * ::sysconf(_SC_PAGESIZE);
}

TEST(Pc2Reader, GivesTheMemoryOfFramesBehindItBack) {
  const TemporaryFolder folder;
  constexpr std::int32_t kPoints = 20000;
  constexpr std::int32_t kFrames = 300;  // 72 MB
  writeBytes(folder / "a.pc2", pc2Header(kPoints, kFrames));
  std::filesystem::resize_file(folder / "a.pc2", 32 + std::uintmax_t{12} * kPoints * kFrames);
  const Result<Pc2Reader> reader = Pc2Reader::open(folder / "a.pc2");
  ASSERT_TRUE(reader) << reader.error().message;
  const std::int64_t before = residentFileBytes();
  std::int64_t most = 0;
  for (std::int32_t f = 0; f < kFrames; ++f) {
    ASSERT_TRUE(reader->frame(f));
    most = std::max(most, residentFileBytes() - before);
  }
  EXPECT_GT(most, 12 * kPoints) << "the measurement sees no frame at all";
  EXPECT_LT(most, 24 << 20);
}

TEST(Pc2Reader, ThreadsMayReadTogether) {
  const TemporaryFolder folder;
  constexpr std::int32_t kPoints = 3000;
  constexpr std::int32_t kFrames = 100;
  std::string bytes = pc2Header(kPoints, kFrames);
  for (std::int32_t f = 0; f < kFrames; ++f) bytes += bytesOf(std::vector<float>(3 * kPoints, static_cast<float>(f)));
  writeBytes(folder / "a.pc2", bytes);
  const Result<Pc2Reader> reader = Pc2Reader::open(folder / "a.pc2");
  ASSERT_TRUE(reader) << reader.error().message;
  std::vector<std::thread> threads;
  std::vector<int> wrong(4);
  for (std::size_t t = 0; t < wrong.size(); ++t) {
    threads.emplace_back([&reader, &count = wrong[t]] {
      for (std::int32_t f = 0; f < kFrames; ++f) {
        const auto frame = reader->frame(f);
        for (const float value : *frame) count += value == static_cast<float>(f) ? 0 : 1;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_THAT(wrong, ElementsAre(0, 0, 0, 0));
}

}  // namespace
}  // namespace honeycomb::Io::Test
