#include "apps/cli/play/history.h"

#include <algorithm>
#include <vector>

namespace honeycomb::Cli::Play {

void History::add(float value) {
  std::shift_left(values_.begin(), values_.end(), 1);
  values_.back() = value;
  count_ = std::min(count_ + 1, kLength);
}

float History::median() const {
  if (count_ == 0) return 0;
  std::vector<float> sorted(values().begin(), values().end());
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return *middle;
}

float History::most() const {
  return count_ == 0 ? 0 : *std::max_element(values().begin(), values().end());
}

}  // namespace honeycomb::Cli::Play
