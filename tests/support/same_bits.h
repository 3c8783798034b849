#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace honeycomb::Test {

/// Are these the same numbers to the last bit, zeros of different signs apart?
template <class Real>
bool sameBits(const std::vector<Real>& a, const std::vector<Real>& b) {
  using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
  return std::ranges::equal(a, b, [](Real x, Real y) { return std::bit_cast<Bits>(x) == std::bit_cast<Bits>(y); });
}

}  // namespace honeycomb::Test
