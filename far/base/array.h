#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>

namespace honeycomb {

constexpr std::size_t kHugePage = std::size_t{2} << 20;

/// Asks for pages of 2 MB where whole ones lie within the block and nothing was written yet (Linux: madvise). A wish: a
/// system without refuses it, and the block is as good.
void wantHugePages(void* block, std::size_t bytes) noexcept;

/// Memory of that many bytes, as operator new gives it. Where the system has pages of 2 MB, blocks of that size and
/// more ask for them (Linux: madvise): first touches of small pages cost several times the writing of a table.
void* allocateBytes(std::size_t bytes);
/// Gives back what allocateBytes(bytes) gave; nullptr is allowed.
void freeBytes(void* block, std::size_t bytes) noexcept;

/// A std::vector of plain numbers whose resize(n) and Array(n) leave new elements as the memory is: for the large
/// arrays that a parallel loop writes once, so that the threads that write touch the memory first. (A std::vector with
/// such an allocator still runs an empty loop over its elements when it grows and when it goes, under gcc 12.)
///
/// An array may also stand for memory of somebody else's, such as a mapped file (inPlaceOf): it is read like others and
/// costs nothing to make. Its elements must not be written to; what changes its size takes a copy first.
template <class T>
class Array {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
  using value_type = T;
  using iterator = T*;
  using const_iterator = const T*;

  Array() = default;
  explicit Array(std::size_t count) { resize(count); }
  Array(std::size_t count, T value) { resize(count, value); }
  Array(std::initializer_list<T> values) : Array(values.begin(), values.end()) {}
  template <std::forward_iterator Iterator>
  Array(Iterator first, Iterator last) {
    append(first, last);
  }
  Array(const Array& other) : Array(other.begin(), other.end()) {}
  Array(Array&& other) noexcept { swap(other); }
  Array& operator=(const Array& other) {
    if (this != &other) assign(other.begin(), other.end());
    return *this;
  }
  Array& operator=(Array&& other) noexcept {
    Array(std::move(other)).swap(*this);
    return *this;
  }
  ~Array() { release(); }

  /// The elements `values` where they are, which `keeper` (not null) keeps there. Moved they stay there, copied they
  /// are the copy's own.
  static Array inPlaceOf(std::span<const T> values, const std::shared_ptr<const void>& keeper) {
    assert(keeper != nullptr);
    Array array;
    array.data_ = const_cast<T*>(values.data());
    array.size_ = values.size();
    array.keeper_ = keeper;
    return array;
  }
  /// Is this memory of somebody else's?
  bool inPlace() const { return keeper_ != nullptr; }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T* data() { return own(); }
  const T* data() const { return data_; }
  T* begin() { return own(); }
  T* end() { return own() + size_; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }
  T& operator[](std::size_t i) {
    assert(i < size_);
    return own()[i];
  }
  const T& operator[](std::size_t i) const {
    assert(i < size_);
    return data_[i];
  }
  T& front() { return (*this)[0]; }
  const T& front() const { return (*this)[0]; }
  T& back() { return (*this)[size_ - 1]; }
  const T& back() const { return (*this)[size_ - 1]; }

  void reserve(std::size_t capacity) {
    if (capacity <= capacity_) return;
    T* data = static_cast<T*>(allocateBytes(capacity * sizeof(T)));
    std::copy(data_, data_ + size_, data);
    release();
    data_ = data;
    capacity_ = capacity;
  }
  /// New elements are not initialised.
  void resize(std::size_t size) {
    if (size > capacity_) reserve(std::max(size, 2 * size_));
    size_ = size;
  }
  /// New elements are `value`.
  void resize(std::size_t size, T value) {
    const std::size_t old = size_;
    resize(size);
    if (old < size) std::fill(data_ + old, data_ + size, value);
  }
  void push_back(T value) {
    resize(size_ + 1);
    back() = value;
  }
  /// [first, last) is no part of this array.
  template <std::forward_iterator Iterator>
  void append(Iterator first, Iterator last) {
    const std::size_t old = size_;
    resize(old + static_cast<std::size_t>(std::distance(first, last)));
    std::copy(first, last, data_ + old);
  }
  template <std::forward_iterator Iterator>
  void assign(Iterator first, Iterator last) {
    size_ = 0;
    append(first, last);
  }

  void swap(Array& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
    std::swap(keeper_, other.keeper_);
  }
  friend bool operator==(const Array& a, const Array& b) { return std::equal(a.begin(), a.end(), b.begin(), b.end()); }

 private:
  T* own() {
    assert(!inPlace() || size_ == 0);
    return data_;
  }
  void release() noexcept {
    if (!inPlace()) freeBytes(data_, capacity_ * sizeof(T));
    keeper_ = nullptr;
  }

  T* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;              // none of memory that isn't ours
  std::shared_ptr<const void> keeper_{};  // of memory that isn't ours
};

}  // namespace honeycomb
