#pragma once

#include <array>
#include <cstddef>

namespace honeycomb::Far {

/// N numbers that are added and scaled together: a point of the surface (N = 3), or a row of weights.
template <std::size_t N>
struct PatchValue {
  std::array<double, N> numbers{};

  double& operator[](std::size_t i) { return numbers[i]; }
  double operator[](std::size_t i) const { return numbers[i]; }

  PatchValue& operator+=(const PatchValue& other) {
    for (std::size_t i = 0; i < N; ++i) numbers[i] += other.numbers[i];
    return *this;
  }
  PatchValue& operator-=(const PatchValue& other) {
    for (std::size_t i = 0; i < N; ++i) numbers[i] -= other.numbers[i];
    return *this;
  }
  PatchValue& operator*=(double factor) {
    for (double& number : numbers) number *= factor;
    return *this;
  }
  friend PatchValue operator+(PatchValue a, const PatchValue& b) { return a += b; }
  friend PatchValue operator-(PatchValue a, const PatchValue& b) { return a -= b; }
  friend PatchValue operator*(double factor, PatchValue a) { return a *= factor; }
};

}  // namespace honeycomb::Far
