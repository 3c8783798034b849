#pragma once

#include <exception>
#include <new>

#include "far/base/result.h"

namespace honeycomb::Cli {

/// What `work` returns, a Result; what it throws as an error.
template <class Work>
auto catching(const Work& work) -> decltype(work()) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::outOfMemory, "out of memory; use fewer --levels, or fewer --threads for a bake");
  } catch (const std::exception& unexpected) {
    return fail(ErrorCode::unreadable, unexpected.what());
  }
}

}  // namespace honeycomb::Cli
