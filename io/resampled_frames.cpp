#include "io/resampled_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/frame_checks.h"

namespace honeycomb::Io {
namespace {

// Of a frame of the source: what falls nearer to one is that one, in spite of rounding.
constexpr double kOnAFrame = 1e-6;

}  // namespace

Result<std::shared_ptr<const FrameSource>> ResampledFrames::create(std::shared_ptr<const FrameSource> source,
                                                                   double sourceRate, double framesPerSecond) {
  const FrameInfo& from = source->info();
  const double step = sourceRate / framesPerSecond;
  const double last = std::floor((from.frameCount - 1) / step + kOnAFrame);
  if (!(framesPerSecond > 0) || !(step > 0) || !(last < std::numeric_limits<std::int32_t>::max()))
    return fail(ErrorCode::invalidOption,
                fmt::format("{} frames a second of {} frames made at {}: give a positive rate that makes fewer than "
                            "2^31 frames",
                            framesPerSecond, from.frameCount, sourceRate));
  std::shared_ptr<ResampledFrames> made(new ResampledFrames(std::move(source), step));
  made->info_ = from;
  made->info_.frameCount = static_cast<std::int32_t>(last) + 1;
  made->info_.framesPerSecond = static_cast<float>(framesPerSecond);
  if (from.countsSeconds()) {
    made->info_.rate = static_cast<float>(1 / framesPerSecond);
  } else {
    made->info_.start = static_cast<float>(from.start / step);
  }
  return made;
}

Result<std::span<const float>> ResampledFrames::frame(std::int32_t f, std::vector<float>& storage) const {
  if (const auto there = checkFrame("the animation", f, info_); !there) return tl::unexpected(there.error());
  const double place = f * step_;
  const std::int32_t last = source_->info().frameCount - 1;
  const std::int32_t before = std::min(static_cast<std::int32_t>(place + kOnAFrame), last);
  const double share = place - before;
  auto former = source_->frame(before, storage);
  if (!former || share <= kOnAFrame || before == last) return former;
  std::vector<float> room;
  auto latter = source_->frame(before + 1, room);
  if (!latter) return latter;
  const auto between = [share](float a, float b) {
    return static_cast<float>((1 - share) * static_cast<double>(a) + share * static_cast<double>(b));
  };
  // `former` may lie in the storage itself.
  const bool here = former->data() == storage.data();
  if (!here) storage.resize(former->size());
  std::transform(former->begin(), former->end(), latter->begin(), storage.begin(), between);
  return storage;
}

}  // namespace honeycomb::Io
