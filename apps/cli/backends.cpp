#include <array>

#include "apps/cli/surface_evaluator.h"

namespace honeycomb::Cli {

std::span<const BackendEntry> backends() {
  // Files are written by the CPU whatever refines them, so `auto` keeps the points there.
  static constexpr std::array kBackends{
      BackendEntry{"auto", true, openTbb},       // as tbb
      BackendEntry{"serial", true, openSerial},  // plain loops
      BackendEntry{"simd", true, openSimd},      // vectors, one thread
      BackendEntry{"tbb", true, openTbb},        // vectors, all threads
      BackendEntry{"vulkan", false, openVulkan},
  };
  return kBackends;
}

}  // namespace honeycomb::Cli
