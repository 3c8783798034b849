#include "apps/cli/play/device_levels.h"

namespace honeycomb::Cli::Play {

nlohmann::ordered_json deviceLevels(std::span<const Osd::LevelTime> levels) {
  auto list = nlohmann::ordered_json::array();
  for (const Osd::LevelTime& time : levels)
    list.push_back({{"level", time.level}, {"what", time.limits ? "limits" : "points"}, {"ms", time.milliseconds}});
  return list;
}

}  // namespace honeycomb::Cli::Play
