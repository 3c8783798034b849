#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

#include "far/base/result.h"
#include "io/frame_layout.h"
#include "io/frame_source.h"
#include "io/stream_writer.h"

namespace honeycomb::Io {

/// A PC2 point cache:
///     "POINTCACHE2\0" | int32 version 1 | int32 points | float start | float rate | int32 frames | float32 xyz ...
/// little-endian; start and rate count frames. It is mapped into memory: pages come in as frames are read and may leave
/// again, so a cache larger than memory works: the memory of frames well before the one being read is given back.
/// Reading is thread-safe; a span stays valid as long as the reader lives.
class Pc2Reader : public FrameSource {
 public:
  /// Errors: unreadable; invalidFile for another kind of file, another version, counts below one, or fewer bytes than
  /// the header promises (the message names the first frame that is cut; element: that frame). Bytes behind the last
  /// frame are passed over.
  static Result<Pc2Reader> open(const std::filesystem::path& path);
  Pc2Reader(Pc2Reader&&) noexcept;
  Pc2Reader& operator=(Pc2Reader&&) noexcept;
  ~Pc2Reader() override;

  const FrameInfo& info() const override;
  /// The 3 x pointCount coordinates of frame f, counted from 0: the file's own bytes, not a copy. Errors:
  /// invalidPositions when one is NaN or infinite (element: vertex; the message names frame and vertex, both from 0);
  /// invalidOption when there is no such frame.
  Result<std::span<const float>> frame(std::int32_t f) const;
  Result<std::span<const float>> frame(std::int32_t f, std::vector<float>& storage) const override;

 private:
  struct Mapping;
  explicit Pc2Reader(std::unique_ptr<Mapping> mapping);
  std::unique_ptr<Mapping> mapping_;
};

/// A PC2 cache to be written; `name` stands for the file in messages. Errors: invalidOption for counts below one.
Result<std::shared_ptr<const FrameLayout>> pc2Layout(std::string_view name, const FrameInfo& info);

/// Streams a PC2 cache frame by frame.
class Pc2Writer : public StreamWriter {
 public:
  /// Errors: StreamWriter's and pc2Layout's.
  static Result<Pc2Writer> create(const std::filesystem::path& path, const FrameInfo& info);

 private:
  explicit Pc2Writer(StreamWriter writer) : StreamWriter(std::move(writer)) {}
};

}  // namespace honeycomb::Io
