#pragma once

#include <cstdint>
#include <functional>

namespace honeycomb::Test {

/// Plays a tenth of the frames that `argv` names (100,000 without), at most 2,000, to become warm, and then all of
/// them. Prints the resident memory before and after these, and their allocations by operator new. The program's exit
/// status: 0 where memory has not grown by more than kMostGrowth and no frame allocated.
int soak(const char* name, int argc, char** argv, const std::function<void(std::uint32_t frame)>& play);

/// Bytes that pages of the system's own (its allocator's, a driver's) may come to in any number of frames.
constexpr std::int64_t kMostGrowth = std::int64_t{1} << 20;

}  // namespace honeycomb::Test
