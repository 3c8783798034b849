#pragma once

#include <cstddef>
#include <type_traits>

namespace honeycomb {

/// Element numbers are signed (-1 means none), container indices are not: this is the one conversion between them.
template <class Integer>
constexpr std::size_t at(Integer i) {
  static_assert(std::is_integral_v<Integer>);
  return static_cast<std::size_t>(i);
}

}  // namespace honeycomb
