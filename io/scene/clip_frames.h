#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/frame_source.h"
#include "io/scene/rig.h"
#include "io/scene/skin.h"

namespace honeycomb::Io {

/// A clip at regular moments: frame f shows second f / framesPerSecond. Each frame is computed when it is asked for, in
/// double, and rounded once.
class ClipFrames : public FrameSource {
 public:
  /// `name` stands for the file in messages.
  ClipFrames(std::string name, Skin skin, std::vector<RigNode> nodes, Clip clip, double framesPerSecond,
             std::int32_t frameCount);

  const FrameInfo& info() const override { return info_; }
  Result<std::span<const float>> frame(std::int32_t f, std::vector<float>& storage) const override;

 private:
  std::string name_;
  Skin skin_;
  std::vector<RigNode> nodes_;
  Clip clip_;
  double framesPerSecond_;
  FrameInfo info_;
};

}  // namespace honeycomb::Io
