#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "far/base/result.h"
#include "io/frame_source.h"

namespace honeycomb::Io {

/// Frames at another rate, from the first of the source's to its last, points on the line between those of the two
/// frames that a moment falls between: in double, rounded once. A moment that falls on a frame has its points as they
/// are.
class ResampledFrames : public FrameSource {
 public:
  /// `sourceRate`: frames a second that the source is taken to have; `framesPerSecond`: those wanted. Errors:
  /// invalidOption for a rate that isn't positive or makes 2^31 frames.
  static Result<std::shared_ptr<const FrameSource>> create(std::shared_ptr<const FrameSource> source, double sourceRate,
                                                           double framesPerSecond);

  /// Times in the source's unit: seconds, or frames of the new rate.
  const FrameInfo& info() const override { return info_; }
  Result<std::span<const float>> frame(std::int32_t f, std::vector<float>& storage) const override;

 private:
  ResampledFrames(std::shared_ptr<const FrameSource> source, double step) : source_(std::move(source)), step_(step) {}

  std::shared_ptr<const FrameSource> source_;
  double step_;  ///< between two frames, in frames of the source
  FrameInfo info_;
};

}  // namespace honeycomb::Io
