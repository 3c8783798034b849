#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>

#include "far/base/array.h"

namespace honeycomb::Bench {

/// Numbers that begin at a cache line, a whole number of lines of them, all zero. On pages of 2 MB where the system has
/// them: with small ones every evaluator would wait for their addresses, too.
class AlignedFloats {
 public:
  explicit AlignedFloats(std::size_t count)
      : size_((count + kLine - 1) / kLine * kLine),
        data_(static_cast<float*>(allocateBytes(bytes())), Release{bytes()}) {
    std::fill_n(data_.get(), size_, 0.0F);
  }

  std::span<float> all() const { return {data_.get(), size_}; }
  std::span<float> first(std::size_t count) const { return all().first(count); }

 private:
  static constexpr std::size_t kLine = 16;
  struct Release {
    std::size_t bytes;
    void operator()(float* data) const { freeBytes(data, bytes); }
  };
  /// Blocks of that size are aligned to it.
  std::size_t bytes() const { return std::max(size_ * sizeof(float), kHugePage); }
  std::size_t size_;
  std::unique_ptr<float, Release> data_;
};

}  // namespace honeycomb::Bench
