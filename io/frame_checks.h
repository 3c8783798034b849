#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "far/base/result.h"
#include "io/frame_source.h"

namespace honeycomb::Io {

/// Is there a frame f? `name` stands for the file in messages. Errors: invalidOption.
Result<void> checkFrame(std::string_view name, std::int32_t f, const FrameInfo& info);

/// Are all coordinates of a frame finite? Linear. Errors: invalidPositions (element: vertex; the message names frame
/// and vertex, both from 0).
Result<void> checkFinite(std::string_view name, std::int64_t frame, std::span<const float> points);

}  // namespace honeycomb::Io
