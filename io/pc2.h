#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "far/base/result.h"
#include "io/frame_source.h"

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

/// Streams a PC2 cache frame by frame. The file appears under its name only at finish(); a writer destroyed before that
/// leaves nothing behind.
class Pc2Writer {
 public:
  /// Errors: unwritable; invalidOption for counts below one.
  static Result<Pc2Writer> create(const std::filesystem::path& path, const FrameInfo& info);
  Pc2Writer(Pc2Writer&&) noexcept;
  Pc2Writer& operator=(Pc2Writer&&) noexcept;
  ~Pc2Writer();

  /// Appends the next frame: 3 x pointCount coordinates. Errors: unwritable (disk full and the like); invalidOption for
  /// another number of coordinates or a frame too many; invalidPositions (element: vertex) for NaN or infinity, which
  /// no reader takes.
  Result<void> write(std::span<const float> points);
  /// Flushes and puts the file under its name. Errors: unwritable, also when fewer frames than promised were written.
  Result<void> finish();

 private:
  struct State;
  explicit Pc2Writer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace honeycomb::Io
