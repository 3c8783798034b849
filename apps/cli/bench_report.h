#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "apps/cli/bench_options.h"
#include "bench/kit/building.h"
#include "bench/kit/comparison.h"

namespace honeycomb::Cli {

/// What was measured of a level in a layout.
struct BenchedLayout {
  std::int32_t level = 0;
  Bench::Layout layout;
  std::int64_t outputBytes = 0;  ///< points of a frame, normals besides
  Bench::Comparisons comparisons;
};

/// What building a level took.
struct BuiltLevel {
  std::int32_t level = 0;
  std::vector<Bench::BuildTime> times;
};

struct BenchReport {
  const BenchCommand& command;
  std::string mesh;
  std::int64_t controlFaces = 0, controlVertices = 0;
  std::vector<BenchedLayout> layouts;
  std::vector<BuiltLevel> builds;
};

/// The heading of the report, one layout's table, one level's building times: printed as they come.
std::string benchHeading(const BenchReport& report);
std::string benchTable(const BenchedLayout& measured);
std::string benchTable(const BuiltLevel& built);

/// The whole, as documented in README.
std::string benchJson(const BenchReport& report);

}  // namespace honeycomb::Cli
