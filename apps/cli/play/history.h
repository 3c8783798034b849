#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "osd/vulkan/binding.h"

namespace honeycomb::Cli::Play {

/// The last values of something measured frame by frame, oldest first.
class History {
 public:
  static constexpr std::size_t kLength = 120;

  void add(float value);
  void clear() { *this = {}; }
  std::span<const float> values() const { return std::span(values_).last(count_); }
  float last() const { return count_ == 0 ? 0 : values_.back(); }
  float median() const;
  float most() const;

 private:
  std::array<float, kLength> values_{};
  std::size_t count_ = 0;
};

/// What a frame took, milliseconds, and how far apart backends were, in units of the last place.
struct FrameReport {
  double evaluate = 0, upload = 0, draw = 0;
  std::vector<Osd::LevelTime> levels{};  ///< where a device refined
};
struct Histories {
  History evaluate, upload, draw, difference;
  std::vector<Osd::LevelTime> levels;  ///< of the last frame; empty where the CPU refined it
};

}  // namespace honeycomb::Cli::Play
