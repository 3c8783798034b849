#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <type_traits>
#include <utility>

namespace honeycomb {

/// Memory of that many bytes, as operator new gives it. Where the system has pages of 2 MB, blocks of that size and
/// more ask for them (Linux: madvise): first touches of small pages cost several times the writing of a table.
void* allocateBytes(std::size_t bytes);
/// Gives back what allocateBytes(bytes) gave; nullptr is allowed.
void freeBytes(void* block, std::size_t bytes) noexcept;

/// A std::vector of plain numbers whose resize(n) and Array(n) leave new elements as the memory is: for the large
/// arrays that a parallel loop writes once, so that the threads that write touch the memory first. (A std::vector with
/// such an allocator still runs an empty loop over its elements when it grows and when it goes, under gcc 12.)
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
  ~Array() { freeBytes(data_, capacity_ * sizeof(T)); }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T* data() { return data_; }
  const T* data() const { return data_; }
  T* begin() { return data_; }
  T* end() { return data_ + size_; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }
  T& operator[](std::size_t i) {
    assert(i < size_);
    return data_[i];
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
    std::copy(begin(), end(), data);
    freeBytes(std::exchange(data_, data), std::exchange(capacity_, capacity) * sizeof(T));
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
    if (old < size) std::fill(begin() + old, end(), value);
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
    std::copy(first, last, begin() + old);
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
  }
  friend bool operator==(const Array& a, const Array& b) { return std::equal(a.begin(), a.end(), b.begin(), b.end()); }

 private:
  T* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

}  // namespace honeycomb
