#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "far/base/result.h"
#include "io/frame_source.h"

namespace honeycomb::Io {

/// A Lightwave MDD point cache, all of it big-endian:
///     int32 frames | int32 points | float32 time of each frame, in seconds | float32 xyz of each point, frame by frame
/// It is mapped into memory as PC2 caches are. Reading is thread-safe.
class MddReader : public FrameSource {
 public:
  /// Errors: unreadable; invalidFile for counts below one, a time that is not finite (element: its frame), or fewer
  /// bytes than the header promises (the message names the first frame that is cut; element: that frame). Bytes behind
  /// the last frame are passed over.
  static Result<MddReader> open(const std::filesystem::path& path);
  MddReader(MddReader&&) noexcept;
  MddReader& operator=(MddReader&&) noexcept;
  ~MddReader() override;

  /// `rate` is the time between the first two frames; `framesPerSecond` what follows from it, 0 where it is not
  /// positive.
  const FrameInfo& info() const override;
  Result<std::span<const float>> frame(std::int32_t f, std::vector<float>& storage) const override;

 private:
  struct Mapping;
  explicit MddReader(std::unique_ptr<Mapping> mapping);
  std::unique_ptr<Mapping> mapping_;
};

}  // namespace honeycomb::Io
