#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "osd/vulkan/kernels.h"

namespace honeycomb::Osd {

/// The SPIR-V of a kernel without the branches that a specialisation never takes: a selection whose condition follows
/// from the constants becomes a jump. It does the same; but drivers inline every call before they look at constants,
/// and lavapipe takes 2 s for the 48 cases of tiles, 0.1 s for the few that a table has. O(words). Code that isn't
/// whole stays as it is.
std::vector<std::uint32_t> prunedCode(std::span<const std::uint32_t> code, const Specialization& specialization);

}  // namespace honeycomb::Osd
