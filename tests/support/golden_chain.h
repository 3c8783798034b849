#pragma once

#include <string>
#include <vector>

#include "far/schemes/scheme.h"

namespace honeycomb::Test {

/// Were the meshes of a golden folder made by a scheme (and not by a conversion)?
bool isRefinedByScheme(const std::string& folder);

/// The chain of steps that a folder's meshes of that level were made by, conversions included.
std::vector<Far::Scheme> goldenChain(const std::string& folder, const Far::Topology& control, std::int32_t level);

}  // namespace honeycomb::Test
