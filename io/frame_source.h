#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "far/base/result.h"

namespace honeycomb::Io {

/// At which frames are played that don't say.
constexpr double kUsualFramesPerSecond = 24;

/// What the frames of a deforming mesh are. Times are in the file's own unit: frames in PC2, seconds in MDD.
struct FrameInfo {
  std::int32_t pointCount = 0;
  std::int32_t frameCount = 0;
  float start = 0;            ///< time of the first frame
  float rate = 1;             ///< time between two
  float framesPerSecond = 0;  ///< as they should be played; 0: the file doesn't say

  double playedAt() const { return framesPerSecond > 0 ? double{framesPerSecond} : kUsualFramesPerSecond; }
  /// Is the time between two frames that of the frame rate? Then times are in seconds; else they count frames.
  bool countsSeconds() const { return std::abs(double{rate} * double{framesPerSecond} - 1) < 1e-3; }
};

/// The points of a deforming mesh, frame by frame: a point cache, a sequence of files, a skinned character.
class FrameSource {
 public:
  virtual ~FrameSource() = default;

  /// What all frames have in common.
  virtual const FrameInfo& info() const = 0;
  /// The 3 x pointCount coordinates of frame f, counted from 0, in `storage` or in memory of the source's own that
  /// lives as long as it does. Thread-safe; any order. Errors: invalidOption when there is no such frame;
  /// invalidPositions when a coordinate is NaN or infinite (element: vertex; the message names frame and vertex, both
  /// from 0); what reading can meet.
  virtual Result<std::span<const float>> frame(std::int32_t f, std::vector<float>& storage) const = 0;

 protected:
  FrameSource() = default;
  FrameSource(const FrameSource&) = default;
  FrameSource(FrameSource&&) = default;
  FrameSource& operator=(const FrameSource&) = default;
  FrameSource& operator=(FrameSource&&) = default;
};

}  // namespace honeycomb::Io
