#include "apps/cli/play/comparison.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace honeycomb::Cli::Play {
namespace {

/// Floats in their order as whole numbers.
std::int64_t rankOf(float number) {
  const auto bits = std::bit_cast<std::int32_t>(number);
  return bits >= 0 ? std::int64_t{bits} : -std::int64_t{bits & 0x7fffffff};
}

}  // namespace

double unitsBetween(float a, float b) {
  return static_cast<double>(std::abs(rankOf(a) - rankOf(b)));
}

Result<double> largestDifference(Stage& stage, std::int32_t frame) {
  std::vector<float> reference;
  double most = 0;
  for (const char* backend : kComparedBackends) {
    const auto posed = stage.pose(backend, frame);
    if (!posed) return tl::unexpected(posed.error());
    const std::span<const float> points = stage.refined();
    if (reference.empty()) reference.assign(points.begin(), points.end());
    for (std::size_t i = 0; i < std::min(points.size(), reference.size()); ++i)
      most = std::max(most, unitsBetween(reference[i], points[i]));
  }
  return most;
}

}  // namespace honeycomb::Cli::Play
