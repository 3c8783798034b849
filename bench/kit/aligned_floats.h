#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>
#include <span>

namespace honeycomb::Bench {

/// Numbers that begin at a cache line, a whole number of lines of them, all zero.
class AlignedFloats {
 public:
  explicit AlignedFloats(std::size_t count)
      : size_((count + kLine - 1) / kLine * kLine),
        data_(static_cast<float*>(::operator new(size_ * sizeof(float), kAlignment))) {
    std::fill_n(data_.get(), size_, 0.0F);
  }

  std::span<float> all() const { return {data_.get(), size_}; }
  std::span<float> first(std::size_t count) const { return all().first(count); }

 private:
  static constexpr std::size_t kLine = 16;
  static constexpr std::align_val_t kAlignment{64};
  struct Release {
    void operator()(float* data) const { ::operator delete(data, kAlignment); }
  };
  std::size_t size_;
  std::unique_ptr<float, Release> data_;
};

}  // namespace honeycomb::Bench
