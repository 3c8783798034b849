#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "osd/vulkan/binding.h"

namespace honeycomb::Cli::Play {

/// What each level took on the device, as the summaries of play have it: [{"level": 1, "what": "points", "ms": 0.2},
/// ..].
nlohmann::ordered_json deviceLevels(std::span<const Osd::LevelTime> levels);

}  // namespace honeycomb::Cli::Play
