#include "far/base/array.h"

#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace honeycomb {

namespace {

constexpr std::size_t kHugePage = std::size_t{2} << 20;

/// The size to ask for: up to whole huge pages where that wastes at most an eighth, else the last ones are small pages.
std::size_t roundedSize(std::size_t bytes) {
  const std::size_t whole = (bytes + kHugePage - 1) / kHugePage * kHugePage;
  return whole - bytes <= bytes / 8 ? whole : bytes;
}

}  // namespace

void* allocateBytes(std::size_t bytes) {
  if (bytes < kHugePage) return ::operator new(bytes);
  const std::size_t size = roundedSize(bytes);
  void* block = ::operator new (size, std::align_val_t{kHugePage});
#ifdef __linux__
  // A wish: a system without huge pages refuses it, and the block is as good.
  (void)::madvise(block, size / kHugePage * kHugePage, MADV_HUGEPAGE);
#endif
  return block;
}

void freeBytes(void* block, std::size_t bytes) noexcept {
  if (bytes < kHugePage) return ::operator delete(block);
  ::operator delete (block, std::align_val_t{kHugePage});
}

}  // namespace honeycomb
