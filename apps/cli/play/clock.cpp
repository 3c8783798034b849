#include "apps/cli/play/clock.h"

#include <algorithm>
#include <cmath>

namespace honeycomb::Cli::Play {
namespace {

constexpr double kFastest = 16;
constexpr double kSlowest = 1.0 / 16;

}  // namespace

PlayClock::PlayClock(std::int32_t frames, double framesPerSecond)
    : frames_(std::max(frames, 1)), framesPerSecond_(framesPerSecond) {}

std::int32_t PlayClock::frame() const {
  return std::clamp(static_cast<std::int32_t>(std::floor(position_)), 0, frames_ - 1);
}

void PlayClock::advance(double seconds) {
  if (!playing_) return;
  position_ += seconds * framesPerSecond_ * speed_;
  if (loop_) {
    position_ -= frames_ * std::floor(position_ / frames_);
    // A sliver below 0 rounds up to the end.
    if (position_ >= frames_) position_ = 0;
    return;
  }
  const bool over = speed_ > 0 ? position_ >= frames_ : position_ <= 0;
  if (!over) return;
  position_ = speed_ > 0 ? frames_ - 1 : 0;
  playing_ = false;
}

void PlayClock::toggle() {
  playing_ = !playing_;
  // From where a playback without a loop ended it begins again.
  if (playing_ && !loop_ && frame() == (speed_ > 0 ? frames_ - 1 : 0)) position_ = speed_ > 0 ? 0 : frames_ - 1;
}

void PlayClock::scrub(std::int32_t frame) {
  position_ = std::clamp(frame, 0, frames_ - 1);
  playing_ = false;
}

void PlayClock::step(std::int32_t frames) {
  const std::int32_t wanted = frame() + frames;
  scrub(loop_ ? (wanted % frames_ + frames_) % frames_ : wanted);
}

void PlayClock::setSpeed(double speed) {
  speed_ = std::copysign(std::clamp(std::abs(speed), kSlowest, kFastest), speed);
}

void PlayClock::change(std::int32_t frames, double framesPerSecond) {
  frames_ = std::max(frames, 1);
  framesPerSecond_ = framesPerSecond;
  if (position_ >= frames_) position_ = 0;
}

}  // namespace honeycomb::Cli::Play
