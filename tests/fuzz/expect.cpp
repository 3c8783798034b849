#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/targets.h"

namespace honeycomb::Fuzz {

void expect(bool kept, const char* promise) {
  if (kept) return;
  std::fprintf(stderr, "not so: %s\n", promise);
  std::abort();
}

}  // namespace honeycomb::Fuzz
