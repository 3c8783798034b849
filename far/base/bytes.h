#pragma once

#include <cstdint>

namespace honeycomb {

/// Bytes of the elements of an array.
template <class Container>
std::int64_t bytes(const Container& c) {
  return static_cast<std::int64_t>(c.size() * sizeof(typename Container::value_type));
}

}  // namespace honeycomb
