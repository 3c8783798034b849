#pragma once

#include <cstdint>

#include "far/base/result.h"
#include "osd/vulkan/core.h"

namespace honeycomb::Osd {

/// How much memory there is, bytes.
struct MemoryRoom {
  std::uint64_t used = 0;   ///< of the limit: by us, or by the whole process where the device tells
  std::uint64_t limit = 0;  ///< what may be used in all
  const char* name = "";    ///< which limit that is
  const char* advice = "";  ///< what raises it
  std::uint64_t left() const { return limit > used ? limit - used : 0; }
};

/// The tightest limit on memory of a heap, asked of the device anew: its budget (VK_EXT_memory_budget) or, where the
/// device tells none, its size; and VulkanEvaluatorOptions::maxDeviceBytes. `held` is what the evaluator holds of all
/// heaps, `heldOfHeap` of this one.
MemoryRoom roomOf(const VulkanCore& core, std::uint32_t heap, std::uint64_t held, std::uint64_t heldOfHeap);

/// outOfMemory: what was asked for, what is in use, what the limit is, and what to do.
Error outOfDeviceMemory(std::uint64_t bytes, const MemoryRoom& room);

}  // namespace honeycomb::Osd
