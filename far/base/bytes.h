#pragma once

#include <cstdint>
#include <vector>

namespace honeycomb {

/// Bytes of the elements of an array.
template <class T>
std::int64_t bytes(const std::vector<T>& v) {
  return static_cast<std::int64_t>(v.size() * sizeof(T));
}

}  // namespace honeycomb
