#pragma once

#include <memory>
#include <string_view>

#include "far/base/result.h"
#include "io/frame_layout.h"
#include "io/frame_source.h"

namespace honeycomb::Io {

/// A LightWave MDD point cache to be written, all of it big-endian:
///     int32 frames | int32 points | float32 times of the frames ... | float32 xyz ...
/// Frame k is at (start + k x rate) / unitsPerSecond: 1 where `info` counts time in seconds. `name` stands for the file
/// in messages. Errors: invalidOption for counts below one, and for times that are not finite or don't ascend.
Result<std::shared_ptr<const FrameLayout>> mddLayout(std::string_view name, const FrameInfo& info,
                                                     double unitsPerSecond = 1);

}  // namespace honeycomb::Io
