// A race on purpose: loop bodies that write the same number. The thread sanitizer must report it, or its silence about
// the project's own loops would mean nothing.
#include <cstdint>
#include <cstdio>

#include "far/base/parallel.h"

int main() {
  std::int64_t sum = 0;
  for (int round = 0; round < 20; ++round) {
    honeycomb::Parallel::forEach(
        0, 100000, [&sum](std::int64_t i) { sum += i; }, 1000);
  }
  std::printf("sum %lld\n", static_cast<long long>(sum));
  return 0;
}
