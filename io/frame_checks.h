#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "far/base/result.h"
#include "io/frame_source.h"

namespace honeycomb::Io {

/// Is there a frame f? `name` stands for the file in messages. Errors: invalidOption.
Result<void> checkFrame(std::string_view name, std::int32_t f, const FrameInfo& info);

/// Do `bytes`, from the first frame on, hold all frames at 12 bytes a point? More may follow. Errors: invalidFile
/// (element: the first frame that is cut, which the message names).
Result<void> checkWhole(std::string_view name, const FrameInfo& info, std::size_t bytes);

/// Are all coordinates of a frame finite? Linear. Errors: invalidPositions (element: vertex; the message names frame
/// and vertex, both from 0).
Result<void> checkFinite(std::string_view name, std::int64_t frame, std::span<const float> points);

}  // namespace honeycomb::Io
