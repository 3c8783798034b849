#pragma once

#include <cstdint>

namespace honeycomb::Cli::Play {

/// Which frame is shown as time goes by.
class PlayClock {
 public:
  /// frames: 1 or more.
  PlayClock(std::int32_t frames, double framesPerSecond);

  /// Lets time pass, seconds; nothing happens while it stands. Without a loop it stops at the last frame.
  void advance(double seconds);
  void toggle();
  /// Shows that frame (held within the animation) and stands.
  void scrub(std::int32_t frame);
  /// So many frames onward or back, round the ends where it loops, and stands.
  void step(std::int32_t frames);
  /// Frames a second over the animation's own: 1/16 to 16; below 0 backwards.
  void setSpeed(double speed);
  void setLoop(bool loop) { loop_ = loop; }
  /// Another animation, at the same place in time where it has one.
  void change(std::int32_t frames, double framesPerSecond);

  std::int32_t frame() const;
  std::int32_t frames() const { return frames_; }
  bool playing() const { return playing_; }
  bool loops() const { return loop_; }
  double speed() const { return speed_; }
  double framesPerSecond() const { return framesPerSecond_; }

 private:
  std::int32_t frames_;
  double framesPerSecond_;
  double position_ = 0;  // frames
  double speed_ = 1;
  bool playing_ = true;
  bool loop_ = true;
};

}  // namespace honeycomb::Cli::Play
