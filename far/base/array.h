#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace honeycomb {

/// Memory of that many bytes, as operator new gives it. Where the system has pages of 2 MB, blocks of that size and
/// more ask for them (Linux: madvise): first touches of small pages cost several times the writing of a table.
void* allocateBytes(std::size_t bytes);
/// Gives back what allocateBytes(bytes) gave; nullptr is allowed.
void freeBytes(void* block, std::size_t bytes) noexcept;

/// An allocator whose containers leave new elements as the memory is instead of setting them to zero: for the large
/// arrays that a parallel loop writes once, so that the threads that write touch the memory first.
template <class T>
struct UninitialisedAllocator {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);
  using value_type = T;

  UninitialisedAllocator() = default;
  template <class U>
  UninitialisedAllocator(const UninitialisedAllocator<U>&) noexcept {}

  T* allocate(std::size_t count) {
    if (count > static_cast<std::size_t>(-1) / 2 / sizeof(T)) throw std::bad_array_new_length();
    return static_cast<T*>(allocateBytes(count * sizeof(T)));
  }
  void deallocate(T* block, std::size_t count) noexcept { freeBytes(block, count * sizeof(T)); }

  template <class U>
  void construct(U* element) noexcept {
    ::new (static_cast<void*>(element)) U;
  }
  template <class U, class... Args>
  void construct(U* element, Args&&... args) {
    ::new (static_cast<void*>(element)) U(std::forward<Args>(args)...);
  }

  template <class U>
  bool operator==(const UninitialisedAllocator<U>&) const {
    return true;
  }
};

/// A vector whose resize(n) and Array(n) leave new elements uninitialised; resize(n, value) and assign set them.
template <class T>
using Array = std::vector<T, UninitialisedAllocator<T>>;

/// Bytes of a vector's elements.
template <class T, class Allocator>
std::int64_t byteSize(const std::vector<T, Allocator>& v) {
  return static_cast<std::int64_t>(v.size() * sizeof(T));
}

}  // namespace honeycomb
