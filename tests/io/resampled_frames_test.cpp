#include "io/resampled_frames.h"

#include <gmock/gmock.h>

#include "io/frame_checks.h"

namespace honeycomb::Io::Test {
namespace {

using testing::ElementsAre;

/// One point on the x axis at the squares of the frames' numbers: in memory of its own, or in the caller's.
class Squares : public FrameSource {
 public:
  Squares(FrameInfo info, bool own) : info_(info), own_(own) {
    info_.pointCount = 1;
    for (std::int32_t f = 0; f < info.frameCount; ++f)
      points_.insert(points_.end(), {static_cast<float>(f * f), 7, -1});
  }
  const FrameInfo& info() const override { return info_; }
  Result<std::span<const float>> frame(std::int32_t f, std::vector<float>& storage) const override {
    if (const auto there = checkFrame("squares", f, info_); !there) return tl::unexpected(there.error());
    const auto point = std::span(points_).subspan(3 * static_cast<std::size_t>(f), 3);
    if (own_) return point;
    storage.assign(point.begin(), point.end());
    return storage;
  }

 private:
  FrameInfo info_;
  bool own_;
  std::vector<float> points_;
};

std::vector<float> xOf(const FrameSource& source) {
  std::vector<float> storage, track;
  for (std::int32_t f = 0; f < source.info().frameCount; ++f) {
    const auto frame = source.frame(f, storage);
    track.push_back((*frame)[0]);
    EXPECT_EQ((*frame)[1], 7);
    EXPECT_EQ((*frame)[2], -1);
  }
  return track;
}

std::shared_ptr<const FrameSource> squares(std::int32_t frames, bool own, float start = 0, float rate = 1,
                                           float framesPerSecond = 0) {
  return std::make_shared<const Squares>(FrameInfo{1, frames, start, rate, framesPerSecond}, own);
}

TEST(ResampledFramesTest, PointsMoveOnLinesBetweenFrames) {
  for (const bool own : {true, false}) {
    EXPECT_THAT(xOf(**ResampledFrames::create(squares(4, own), 24, 48)), ElementsAre(0, 0.5, 1, 2.5, 4, 6.5, 9)) << own;
    EXPECT_THAT(xOf(**ResampledFrames::create(squares(4, own), 24, 12)), ElementsAre(0, 4)) << own;
    EXPECT_THAT(xOf(**ResampledFrames::create(squares(4, own), 24, 16)), ElementsAre(0, 2.5, 9)) << own;
  }
}

TEST(ResampledFramesTest, MomentsOnAFrameHaveItsBitsInSpiteOfRounding) {
  const auto source = squares(3001, true);
  const auto thirds = ResampledFrames::create(source, 10, 30);
  ASSERT_EQ((*thirds)->info().frameCount, 9001);
  std::vector<float> storage;
  for (std::int32_t f = 0; f < 3001; ++f) EXPECT_EQ((*(*thirds)->frame(3 * f, storage))[0], static_cast<float>(f * f));
}

TEST(ResampledFramesTest, TimesStayInTheSourcesUnit) {
  const FrameInfo frames = (*ResampledFrames::create(squares(4, true, 10), 24, 48))->info();
  EXPECT_EQ(frames.start, 20);
  EXPECT_EQ(frames.rate, 1);
  EXPECT_EQ(frames.framesPerSecond, 48);
  const FrameInfo seconds = (*ResampledFrames::create(squares(4, true, 2, 0.04F, 25), 25, 50))->info();
  EXPECT_EQ(seconds.start, 2);
  EXPECT_EQ(seconds.rate, 0.02F);
  EXPECT_EQ(seconds.framesPerSecond, 50);
}

TEST(ResampledFramesTest, OneFrameStaysOne) {
  EXPECT_THAT(xOf(**ResampledFrames::create(squares(1, true), 24, 60)), ElementsAre(0));
}

TEST(ResampledFramesTest, RatesThatMakeNoFramesAreRefused) {
  for (const double rate : {0.0, -1.0, 1e12, std::numeric_limits<double>::infinity()})
    EXPECT_EQ(ResampledFrames::create(squares(4, true), 24, rate).error().code, ErrorCode::invalidOption) << rate;
  const auto made = *ResampledFrames::create(squares(4, true), 24, 48);
  std::vector<float> storage;
  EXPECT_EQ(made->frame(7, storage).error().code, ErrorCode::invalidOption);
}

}  // namespace
}  // namespace honeycomb::Io::Test
