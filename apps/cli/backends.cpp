#include <array>

#include "apps/cli/surface_evaluator.h"

namespace honeycomb::Cli {

std::span<const BackendEntry> backends() {
  // Files are written by the CPU whatever refines them, so `auto` keeps the points there.
  static constexpr std::array kBackends{
      BackendEntry{"auto", true, openTbb},
      BackendEntry{"serial", true, openSerial},
      BackendEntry{"tbb", true, openTbb},
      BackendEntry{"vulkan", false, openVulkan},
  };
  return kBackends;
}

}  // namespace honeycomb::Cli
