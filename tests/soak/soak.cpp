#include "tests/soak/soak.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <new>
#include <string>

namespace {

std::atomic<std::int64_t> allocations{0};

void* counted(std::size_t bytes) {
  ++allocations;
  void* const data = std::malloc(bytes == 0 ? 1 : bytes);
  if (data == nullptr) throw std::bad_alloc();
  return data;
}

std::int64_t residentBytes() {
  std::int64_t total = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> total >> resident;
  return resident * ::sysconf(_SC_PAGESIZE);
}

}  // namespace

// libstdc++'s own operator delete frees what malloc() gave.
void* operator new(std::size_t bytes) {
  return counted(bytes);
}
void* operator new[](std::size_t bytes) {
  return counted(bytes);
}
namespace honeycomb::Test {

int soak(const char* name, int argc, char** argv, const std::function<void(std::uint32_t frame)>& play) {
  const auto frames = static_cast<std::uint32_t>(argc > 1 ? std::stoul(argv[1]) : 100'000);
  const std::uint32_t warm = std::min(frames / 10, 2000U);
  for (std::uint32_t frame = 0; frame < warm; ++frame) play(frame);
  const std::int64_t before = residentBytes(), allocationsBefore = allocations;
  for (std::uint32_t frame = 0; frame < frames; ++frame) play(frame);
  const std::int64_t allocated = allocations - allocationsBefore;
  const std::int64_t after = residentBytes();
  std::cout << name << ": " << frames << " frames, resident " << before / 1024 << " KiB before, " << after / 1024
            << " KiB after, " << allocated << " allocations\n";
  return after - before <= kMostGrowth && allocated == 0 ? 0 : 1;
}

}  // namespace honeycomb::Test
