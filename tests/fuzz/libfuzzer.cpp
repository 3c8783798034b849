// One target (the macro's) as a program of libFuzzer's, which brings its own main.
#include <cstddef>

#include "tests/fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  honeycomb::Fuzz::HONEYCOMB_FUZZ_TARGET({data, size});
  return 0;
}
