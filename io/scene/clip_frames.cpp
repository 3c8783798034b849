#include "io/scene/clip_frames.h"

#include <utility>

#include "io/frame_checks.h"

namespace honeycomb::Io {

ClipFrames::ClipFrames(std::string name, Skin skin, std::vector<RigNode> nodes, Clip clip, double framesPerSecond,
                       std::int32_t frameCount)
    : name_(std::move(name)),
      skin_(std::move(skin)),
      nodes_(std::move(nodes)),
      clip_(std::move(clip)),
      framesPerSecond_(framesPerSecond) {
  info_.pointCount = static_cast<std::int32_t>(skin_.vertexCount());
  info_.frameCount = frameCount;
  info_.framesPerSecond = static_cast<float>(framesPerSecond);
}

Result<std::span<const float>> ClipFrames::frame(std::int32_t f, std::vector<float>& storage) const {
  if (const auto there = checkFrame(name_, f, info_); !there) return tl::unexpected(there.error());
  const std::vector<double> points = poseSkin(skin_, nodes_, &clip_, f / framesPerSecond_);
  storage.assign(points.begin(), points.end());
  if (const auto finite = checkFinite(name_, f, storage); !finite) return tl::unexpected(finite.error());
  return storage;
}

}  // namespace honeycomb::Io
