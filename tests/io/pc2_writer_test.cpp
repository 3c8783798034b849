#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "io/pc2.h"
#include "tests/io/files.h"
#include "tests/io/pc2_bytes.h"
#include "tests/io/random_reals.h"

namespace honeycomb::Io::Test {
namespace {

const std::vector<float> kFrame{0, 1, 2, 3, 4, 5};  // of two points

TEST(Pc2Writer, WritesHeaderAndFrames) {
  const TemporaryFolder folder;
  Result<Pc2Writer> created = Pc2Writer::create(folder / "a.pc2", {2, 2, 0.5F, 0.25F});
  ASSERT_TRUE(created) << created.error().message;
  Pc2Writer writer = *std::move(created);
  ASSERT_TRUE(writer.write(kFrame));
  ASSERT_TRUE(writer.write(kFrame));
  EXPECT_FALSE(std::filesystem::exists(folder / "a.pc2")) << "before finish";
  ASSERT_TRUE(writer.finish());
  EXPECT_EQ(readBytes(folder / "a.pc2"), pc2Header(2, 2) + bytesOf(kFrame) + bytesOf(kFrame));
}

TEST(Pc2Writer, FramesComeBackToTheSameBits) {
  const TemporaryFolder folder;
  const std::vector<float> values = randomReals<float>(300000);
  const std::span<const float> all(values);
  Result<Pc2Writer> writer = Pc2Writer::create(folder / "a.pc2", {10000, 10, 1, 2});
  ASSERT_TRUE(writer) << writer.error().message;
  for (std::size_t f = 0; f < 10; ++f) ASSERT_TRUE(writer->write(all.subspan(30000 * f, 30000)));
  ASSERT_TRUE(writer->finish());
  const Result<Pc2Reader> reader = Pc2Reader::open(folder / "a.pc2");
  ASSERT_TRUE(reader) << reader.error().message;
  for (std::int32_t f = 0; f < 10; ++f) {
    const auto expected = all.subspan(30000 * static_cast<std::size_t>(f), 30000);
    EXPECT_EQ(bitsOf<float>(*reader->frame(f)), bitsOf<float>(expected)) << "frame " << f;
  }
}

TEST(Pc2Writer, LeavesNothingWhenNotFinished) {
  const TemporaryFolder folder;
  {
    Result<Pc2Writer> writer = Pc2Writer::create(folder / "a.pc2", {2, 2, 0, 1});
    ASSERT_TRUE(writer) << writer.error().message;
    ASSERT_TRUE(writer->write(kFrame));
  }
  EXPECT_EQ(folder.entries(), 0);
}

TEST(Pc2Writer, RefusesToFinishWithFramesMissing) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.pc2").string();
  Result<Pc2Writer> writer = Pc2Writer::create(path, {2, 2, 0, 1});
  ASSERT_TRUE(writer) << writer.error().message;
  ASSERT_TRUE(writer->write(kFrame));
  const Result<void> finished = writer->finish();
  ASSERT_FALSE(finished);
  EXPECT_EQ(finished.error().code, ErrorCode::unwritable);
  EXPECT_EQ(finished.error().message, path + ": only 1 of 2 frames were written; write them all before finish");
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(Pc2Writer, RefusesFramesThatDoNotFit) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.pc2").string();
  Result<Pc2Writer> writer = Pc2Writer::create(path, {2, 1, 0, 1});
  ASSERT_TRUE(writer) << writer.error().message;
  const Result<void> tooShort = writer->write(std::span(kFrame).first(5));
  ASSERT_FALSE(tooShort);
  EXPECT_EQ(tooShort.error().message, path + ": frame 0 has 5 coordinates; give 3 for each of 2 points");
  ASSERT_TRUE(writer->write(kFrame));
  const Result<void> tooMany = writer->write(kFrame);
  ASSERT_FALSE(tooMany);
  EXPECT_EQ(tooMany.error().message, path + ": has all its 1 frames; create it with the number you write");
}

TEST(Pc2Writer, RefusesNan) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.pc2").string();
  Result<Pc2Writer> writer = Pc2Writer::create(path, {2, 1, 0, 1});
  ASSERT_TRUE(writer) << writer.error().message;
  const std::vector<float> points{0, 0, 0, NAN, 0, 0};
  const Result<void> written = writer->write(points);
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::invalidPositions);
  EXPECT_EQ(written.error().element, 1);
  EXPECT_EQ(written.error().message,
            path + ": vertex 1 of frame 0 (both counted from 0) has the coordinate nan; give it a finite position");
}

TEST(Pc2Writer, RefusesEmptyCaches) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.pc2").string();
  const Result<Pc2Writer> writer = Pc2Writer::create(path, {0, 3, 0, 1});
  ASSERT_FALSE(writer);
  EXPECT_EQ(writer.error().code, ErrorCode::invalidOption);
  EXPECT_EQ(writer.error().message,
            path + ": a PC2 cache of 0 points and 3 frames cannot be; give one or more of each");
  EXPECT_FALSE(Pc2Writer::create(path, {3, 0, 0, 1}));
  EXPECT_EQ(folder.entries(), 0);
}

TEST(Pc2Writer, FullDiskIsAnErrorAndLeavesNothing) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.pc2").string();
  {
    const FileSizeLimit limit(100000);
    Result<Pc2Writer> writer = Pc2Writer::create(path, {100000, 1, 0, 1});
    ASSERT_TRUE(writer) << writer.error().message;
    const Result<void> written = writer->write(std::vector<float>(300000));
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, ErrorCode::unwritable);
    EXPECT_EQ(written.error().message,
              path + ": cannot be written: File too large; free some space or choose another place");
  }
  EXPECT_EQ(folder.entries(), 0);
}

}  // namespace
}  // namespace honeycomb::Io::Test
