#pragma once

#include <cstdint>
#include <span>

#include "far/base/result.h"

namespace honeycomb::Io {

/// Takes the refined or recorded frames of a deforming mesh, and puts them where they are to be.
class FrameWriter {
 public:
  virtual ~FrameWriter() = default;

  /// Frame f, counted from 0: 3 coordinates for each point; each frame once, thread-safe and in any order where the
  /// class doesn't say otherwise. Errors: unwritable (disk full and the like); invalidOption for a frame there isn't,
  /// or another number of coordinates; invalidPositions (element: vertex) for NaN or infinity, which no reader takes.
  virtual Result<void> write(std::int32_t f, std::span<const float> points) = 0;
  /// All frames there are for this writer are written: to the disk with them. Errors: unwritable.
  virtual Result<void> close() = 0;

 protected:
  FrameWriter() = default;
  FrameWriter(const FrameWriter&) = default;
  FrameWriter(FrameWriter&&) = default;
  FrameWriter& operator=(const FrameWriter&) = default;
  FrameWriter& operator=(FrameWriter&&) = default;
};

}  // namespace honeycomb::Io
