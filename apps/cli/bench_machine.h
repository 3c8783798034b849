#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace honeycomb::Cli {

/// A cache of the first processor.
struct Cache {
  int level = 0;
  std::string type;  ///< "Data", "Instruction", "Unified"
  std::int64_t bytes = 0;
};
/// As the system tells; none where it doesn't.
std::vector<Cache> processorCaches();

/// What compiled this program, and with which flags.
std::string compilerName();
std::string compilerFlags();

}  // namespace honeycomb::Cli
