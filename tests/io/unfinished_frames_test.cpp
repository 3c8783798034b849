#include "io/unfinished_frames.h"

#include <gtest/gtest.h>

#include <numeric>

#include "far/base/parallel.h"
#include "io/block_writer.h"
#include "io/checksum.h"
#include "io/pc2.h"
#include "tests/io/files.h"

namespace honeycomb::Io::Test {
namespace {

class UnfinishedFileTest : public testing::Test {
 protected:
  static constexpr std::int32_t kPoints = 5, kFrames = 40;
  const TemporaryFolder folder_;
  const std::filesystem::path path_ = folder_ / "a.pc2";
  const std::shared_ptr<const FrameLayout> layout_ = *pc2Layout("a.pc2", {kPoints, kFrames, 0, 1});

  static std::vector<float> points(std::int32_t frame) {
    std::vector<float> values(3 * kPoints);
    std::iota(values.begin(), values.end(), static_cast<float>(100 * frame));
    return values;
  }
  std::unique_ptr<UnfinishedFile> open(std::uint64_t asked = 1, bool restart = false) const {
    auto file = UnfinishedFile::open(path_, layout_, {asked, restart});
    EXPECT_TRUE(file) << file.error().message;
    return file ? std::move(*file) : nullptr;
  }
  BlockWriter writer(const UnfinishedFile& file) const {
    return {path_.string(), layout_, *openBlockFile(file.partialFile(), path_), *openBlockFile(file.journal(), path_)};
  }
  void write(const UnfinishedFile& file, std::vector<std::int32_t> frames) const {
    BlockWriter frameWriter = writer(file);
    for (const std::int32_t f : frames) ASSERT_TRUE(frameWriter.write(f, points(f)));
    ASSERT_TRUE(frameWriter.close());
  }
};

TEST_F(UnfinishedFileTest, ThreadsWriteTheFramesInAnyOrder) {
  const auto file = open();
  BlockWriter frameWriter = writer(*file);
  Parallel::forEach(
      0, kFrames,
      [&](std::int64_t i) {
        const auto f = static_cast<std::int32_t>(kFrames - 1 - i);
        EXPECT_TRUE(frameWriter.write(f, points(f)));
      },
      1);
  ASSERT_TRUE(frameWriter.close());
  ASSERT_TRUE(file->finish());
  Result<Pc2Writer> inOrder = Pc2Writer::create(folder_ / "order.pc2", layout_->info());
  for (std::int32_t f = 0; f < kFrames; ++f) ASSERT_TRUE(inOrder->write(points(f)));
  ASSERT_TRUE(inOrder->finish());
  EXPECT_EQ(readBytes(path_), readBytes(folder_ / "order.pc2"));
  EXPECT_EQ(folder_.entries(), 2) << "nothing beside the two";
}

TEST_F(UnfinishedFileTest, WhatIsWholeIsFoundAgain) {
  write(*open(), {0, 3, 39});
  EXPECT_FALSE(std::filesystem::exists(path_));
  const auto again = open();
  EXPECT_EQ(again->found(), Found::same);
  EXPECT_EQ(again->missing().size(), kFrames - 3U);
  EXPECT_EQ(again->wholeFrames(), 3);
  EXPECT_EQ(again->missing().front(), 1);
  EXPECT_EQ(again->missing().back(), 38);
}

TEST_F(UnfinishedFileTest, FinishWantsAllFrames) {
  const auto file = open();
  write(*file, {0, 3, 39});
  const Result<void> finished = file->finish();
  ASSERT_FALSE(finished);
  EXPECT_EQ(finished.error().message,
            path_.string() + ": only 3 of 40 frames were written; write them all before finish");
  EXPECT_FALSE(std::filesystem::exists(path_));
}

TEST_F(UnfinishedFileTest, AnotherTaskOrARestartDropsIt) {
  write(*open(), {0, 3, 39});
  const auto restarted = open(1, true);
  EXPECT_EQ(restarted->missing().size(), std::size_t{kFrames});
  write(*restarted, {7});
}

TEST_F(UnfinishedFileTest, AnotherTaskIsTold) {
  write(*open(), {0, 3, 39});
  const auto other = open(2);
  EXPECT_EQ(other->found(), Found::other);
  EXPECT_EQ(other->missing().size(), std::size_t{kFrames});
}

TEST_F(UnfinishedFileTest, AFrameThatTheDiskHasLostIsMissing) {
  write(*open(), {0, 3, 39});
  std::filesystem::resize_file(*std::filesystem::directory_iterator(folder_.path()), 0);  // either of the two
  EXPECT_EQ(open()->missing().size(), std::size_t{kFrames});
}

TEST_F(UnfinishedFileTest, OneRunAtATime) {
  const auto first = open();
  const auto second = UnfinishedFile::open(path_, layout_, {1, false});
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().message,
            path_.string() + ": is being written by another run; wait for it or give another output");
}

TEST_F(UnfinishedFileTest, DiscardLeavesNothing) {
  const auto file = open();
  write(*file, {0, 3});
  file->discard();
  EXPECT_EQ(folder_.entries(), 0);
}

TEST_F(UnfinishedFileTest, ALinkIsWrittenThrough) {
  std::filesystem::create_directory(folder_ / "far");
  std::filesystem::create_symlink("far/b.pc2", path_);
  const auto file = open();
  std::vector<std::int32_t> all(kFrames);
  std::iota(all.begin(), all.end(), 0);
  write(*file, all);
  ASSERT_TRUE(file->finish());
  EXPECT_TRUE(std::filesystem::is_symlink(path_));
  EXPECT_TRUE(std::filesystem::is_regular_file(folder_ / "far/b.pc2"));
}

TEST_F(UnfinishedFileTest, PipesHaveNoOrderButTheirs) {
  const auto file = UnfinishedFile::open("/dev/null", layout_, {});
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, ErrorCode::invalidOption);
}

TEST(Checksum, PiecesCountAsTheWhole) {
  const std::vector<std::byte> bytes(1000, std::byte{7});
  Checksum sum;
  sum.add(std::span(bytes).first(123));
  sum.add(std::span(bytes).subspan(123));
  EXPECT_EQ(sum.value(), checksum(bytes));
  EXPECT_NE(sum.value(), checksum(std::span(bytes).first(999)));
}

/// Writes down what is asked of it.
class ListedFile : public BlockFile {
 public:
  ListedFile(std::string name, std::vector<std::string>& calls) : name_(std::move(name)), calls_(calls) {}
  Result<void> writeAt(std::int64_t, std::span<const std::byte>) override { return list("write "); }
  Result<void> sync() override { return list("sync "); }
  Result<void> close() override { return list("close "); }

 private:
  Result<void> list(const std::string& call) {
    calls_.push_back(call + name_);
    return {};
  }
  std::string name_;
  std::vector<std::string>& calls_;
};

std::vector<std::string> callsOfTwoFrames(std::chrono::steady_clock::duration syncEvery) {
  std::vector<std::string> calls;
  const auto layout = *pc2Layout("a.pc2", {1, 2, 0, 1});
  BlockWriter writer("a.pc2", layout, std::make_unique<ListedFile>("frames", calls),
                     std::make_unique<ListedFile>("journal", calls), syncEvery);
  for (const std::int32_t f : {0, 1}) EXPECT_TRUE(writer.write(f, std::vector<float>{1, 2, 3}));
  EXPECT_TRUE(writer.close());
  return calls;
}

// A journal on the disk names no frame that isn't there: frames go first.
TEST(BlockWriterTest, FramesGoToTheDiskAheadOfTheirJournal) {
  const std::vector<std::string> eachFrame{"write frames", "write journal", "sync frames", "sync journal"};
  std::vector<std::string> expected = eachFrame;
  expected.insert(expected.end(), eachFrame.begin(), eachFrame.end());
  expected.insert(expected.end(), {"close frames", "close journal"});
  EXPECT_EQ(callsOfTwoFrames(std::chrono::seconds(0)), expected);
}

TEST(BlockWriterTest, FramesDontWaitForTheDiskOneByOne) {
  EXPECT_EQ(callsOfTwoFrames(std::chrono::hours(1)),
            (std::vector<std::string>{"write frames", "write journal", "write frames", "write journal", "close frames",
                                      "close journal"}));
}

}  // namespace
}  // namespace honeycomb::Io::Test
