#pragma once

#include <stdexcept>
#include <utility>

#include "far/base/result.h"

namespace honeycomb::Test {

/// The value of a result that must have one; throws its error's message otherwise, which fails the test.
template <class T>
T must(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().message);
  return std::move(*result);
}

inline void must(const Result<void>& result) {
  if (!result) throw std::runtime_error(result.error().message);
}

}  // namespace honeycomb::Test
