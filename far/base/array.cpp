#include "far/base/array.h"

#include <cstddef>
#include <cstdint>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace honeycomb {

namespace {

/// The size to ask for: up to whole huge pages where that wastes at most an eighth, else the last ones are small pages.
std::size_t roundedSize(std::size_t bytes) {
  const std::size_t whole = (bytes + kHugePage - 1) / kHugePage * kHugePage;
  return whole - bytes <= bytes / 8 ? whole : bytes;
}

}  // namespace

void wantHugePages([[maybe_unused]] void* block, [[maybe_unused]] std::size_t bytes) noexcept {
#ifdef __linux__
  const std::size_t before = (kHugePage - reinterpret_cast<std::uintptr_t>(block) % kHugePage) % kHugePage;
  if (bytes < before + kHugePage) return;
  (void)::madvise(static_cast<std::byte*>(block) + before, (bytes - before) / kHugePage * kHugePage, MADV_HUGEPAGE);
#endif
}

void* allocateBytes(std::size_t bytes) {
  if (bytes < kHugePage) return ::operator new(bytes);
  const std::size_t size = roundedSize(bytes);
  void* block = ::operator new (size, std::align_val_t{kHugePage});
  wantHugePages(block, size);
  return block;
}

void freeBytes(void* block, std::size_t bytes) noexcept {
  if (bytes < kHugePage) return ::operator delete(block);
  ::operator delete (block, std::align_val_t{kHugePage});
}

}  // namespace honeycomb
