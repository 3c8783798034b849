#pragma once

#include <new>
#include <stdexcept>

#include "far/base/result.h"

namespace honeycomb::Osd {

/// outOfMemory of the host, even where there is none left for the message.
inline Error outOfHostMemory() noexcept {
  try {
    return {ErrorCode::outOfMemory, "out of memory: refine fewer levels, or use a smaller mesh"};
  } catch (const std::bad_alloc&) {
    return {ErrorCode::outOfMemory, "out of memory"};  // within std::string itself
  }
}

/// What `work` returns, a Result; where memory runs out meanwhile, that as an error. No exception of the standard
/// library passes what callers see.
template <class Work>
auto guarded(const Work& work) -> decltype(work()) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return tl::unexpected(outOfHostMemory());
  } catch (const std::length_error&) {
    return tl::unexpected(outOfHostMemory());
  }
}

}  // namespace honeycomb::Osd
