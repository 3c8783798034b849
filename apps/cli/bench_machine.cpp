#include "apps/cli/bench_machine.h"

#include <fstream>
#include <string_view>

namespace honeycomb::Cli {

std::vector<Cache> processorCaches() {
  std::vector<Cache> caches;
  for (int i = 0;; ++i) {
    const std::string folder = "/sys/devices/system/cpu/cpu0/cache/index" + std::to_string(i) + "/";
    Cache cache;
    std::string size;
    std::ifstream(folder + "level") >> cache.level;
    std::ifstream(folder + "type") >> cache.type;
    // "2048K"
    if (!(std::ifstream(folder + "size") >> size)) return caches;
    cache.bytes = std::stoll(size) * (size.back() == 'K' ? 1024 : 1);
    caches.push_back(cache);
  }
}

std::string compilerName() {
#ifdef __clang__
  return "clang " __clang_version__;
#else
  return "gcc " __VERSION__;
#endif
}

std::string compilerFlags() {
  return HONEYCOMB_FLAGS;
}

}  // namespace honeycomb::Cli
