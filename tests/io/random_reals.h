#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <type_traits>
#include <vector>

namespace honeycomb::Io::Test {

template <class Real>
using BitsOf = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;

/// The bits of each number: unlike ==, they tell -0 from 0.
template <class Real, class Range>
std::vector<BitsOf<Real>> bitsOf(const Range& values) {
  std::vector<BitsOf<Real>> bits;
  for (const auto value : values) bits.push_back(std::bit_cast<BitsOf<Real>>(static_cast<Real>(value)));
  return bits;
}

/// The ends of every range of finite numbers, then finite numbers of random bits: all exponents, denormals too.
template <class Real>
std::vector<Real> randomReals(std::size_t count) {
  using Limits = std::numeric_limits<Real>;
  std::vector<Real> values{Real(0),
                           -Real(0),
                           Limits::max(),
                           Limits::lowest(),
                           Limits::min(),
                           Limits::denorm_min(),
                           -Limits::denorm_min(),
                           Limits::min() - Limits::denorm_min(),
                           Limits::epsilon(),
                           Real(0.1)};
  std::mt19937_64 random(20240607);
  while (values.size() < count) {
    const Real value = std::bit_cast<Real>(static_cast<BitsOf<Real>>(random()));
    if (std::isfinite(value)) values.push_back(value);
  }
  return values;
}

}  // namespace honeycomb::Io::Test
