#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <utility>
#include <vector>

#include "far/base/result.h"
#include "io/frame_source.h"

namespace honeycomb::Io {

/// How the frames of a deforming mesh lie in one file: a header, then every frame in as many bytes as the others,
///     | header | frame 0 | frame 1 | ...
/// so that any frame can be written at any time by anybody. Immutable, shared by threads. A format is one of these.
class FrameLayout {
 public:
  virtual ~FrameLayout() = default;

  const FrameInfo& info() const { return info_; }
  std::span<const std::byte> header() const { return header_; }
  std::int64_t frameBytes() const { return frameBytes_; }
  /// Bytes of the file before frame f.
  std::int64_t frameOffset(std::int32_t f) const { return std::ssize(header_) + f * frameBytes_; }
  std::int64_t fileBytes() const { return frameOffset(info_.frameCount); }

  /// The bytes of frame f, whose points are sound: its points as they stand, or made in `storage`.
  virtual std::span<const std::byte> encode(std::int32_t f, std::span<const float> points,
                                            std::vector<std::byte>& storage) const = 0;
  /// Sets what depends on all frames, once they are all in `file`. May be done again. Errors: unreadable, unwritable.
  virtual Result<void> complete(const std::filesystem::path& file) const;
  /// Does complete() do anything? Then the file can't go through a pipe.
  virtual bool completes() const { return false; }

 protected:
  FrameLayout(FrameInfo info, std::vector<std::byte> header, std::int64_t frameBytes)
      : info_(info), header_(std::move(header)), frameBytes_(frameBytes) {}

 private:
  FrameInfo info_;
  std::vector<std::byte> header_;
  std::int64_t frameBytes_ = 0;
};

inline Result<void> FrameLayout::complete(const std::filesystem::path& /*file*/) const {
  return {};
}

}  // namespace honeycomb::Io
