#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "far/base/result.h"
#include "io/frame_source.h"

namespace honeycomb::Io {

/// Can these be the points of frame f of `info`? Errors: invalidOption for a frame there isn't and for another number
/// of coordinates than 3 for each point; invalidPositions for NaN and infinity, as checkFinite() has it.
Result<void> checkWritten(std::string_view name, const FrameInfo& info, std::int32_t f, std::span<const float> points);

/// Errors: invalidOption, for counts below one; `kind` names what the file is ("a PC2 cache").
Result<void> checkCounts(std::string_view name, std::string_view kind, const FrameInfo& info);

}  // namespace honeycomb::Io
