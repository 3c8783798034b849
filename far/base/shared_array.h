#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

#include "far/base/array.h"

namespace honeycomb {

/// An array of numbers that copies share, and share with whatever else holds it, until one of them is edited. Reading
/// is as with Array; writers take edit() once.
template <class T>
class SharedArray {
 public:
  using value_type = T;
  using iterator = const T*;
  using const_iterator = const T*;

  SharedArray() = default;
  SharedArray(Array<T> values) : own_(std::make_shared<Array<T>>(std::move(values))), array_(own_) {}
  /// Shares what another owner keeps.
  explicit SharedArray(std::shared_ptr<const Array<T>> values) : array_(std::move(values)) {}

  std::size_t size() const { return array_ ? array_->size() : 0; }
  bool empty() const { return size() == 0; }
  const T* data() const { return array_ ? array_->data() : nullptr; }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size(); }
  const T& operator[](std::size_t i) const { return (*array_)[i]; }

  /// The numbers to write to, of this array alone: copied if they are shared. Linear then.
  Array<T>& edit() {
    // Not shared, it is held by the two pointers here.
    if (!own_ || own_.use_count() > 2) *this = SharedArray(array_ ? *array_ : Array<T>());
    return *own_;
  }
  /// Is it this very array, not one with the same values?
  bool sharesWith(const std::shared_ptr<const Array<T>>& values) const { return array_ == values; }

  friend bool operator==(const SharedArray& a, const SharedArray& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }

 private:
  std::shared_ptr<Array<T>> own_;  // none where another owner keeps them
  std::shared_ptr<const Array<T>> array_;
};

}  // namespace honeycomb
