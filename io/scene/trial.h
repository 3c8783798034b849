#pragma once

#include <filesystem>
#include <functional>

#include "far/base/result.h"

namespace honeycomb::Io {

/// Does reading `path` come to an end? Runs `reading` in a copy of this process, whose output goes nowhere, and waits
/// for it: what a damaged file brings down is the copy. `reading` must not need other threads; what it throws or
/// returns isn't looked at. Errors: invalidFile, where the copy was killed or took longer than `seconds`; outOfMemory,
/// where no copy can be made.
Result<void> tryReading(const std::filesystem::path& path, const std::function<void()>& reading, unsigned seconds = 60);

}  // namespace honeycomb::Io
