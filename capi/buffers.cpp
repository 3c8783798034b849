#include "capi/buffers.h"

namespace honeycomb::Capi {
namespace {

/// Interleaved points don't overlap: the same stride, and values that stand beside each other.
bool overlap(const Extent& a, const Extent& b) {
  if (a.end <= b.begin || b.end <= a.begin) return false;
  if (a.stride != b.stride || (a.begin - b.begin) % sizeof(float) != 0) return true;
  const Extent& low = a.begin <= b.begin ? a : b;
  const Extent& high = a.begin <= b.begin ? b : a;
  const auto between = static_cast<std::int64_t>((high.begin - low.begin) / sizeof(float)) % low.stride;
  return between < low.length || between + high.length > low.stride;
}

}  // namespace

Result<void> checkApart(const Extent& read, const Extent& first, const Extent& second) {
  if (overlap(read, first) || overlap(read, second))
    return refuse("points that are written overlap those that are read; give other memory");
  if (overlap(first, second))
    return refuse("positions and normals overlap; give other memory, or interleave them by offset and stride");
  return {};
}

Result<void> checkFinite(const hc_points& given, std::int64_t points, std::int64_t vertices) {
  for (std::int64_t p = 0; p < points; ++p) {
    const float* values = given.data + given.offset + p * given.stride;
    // x - x is 0 but for NaN and infinity.
    float sum = 0;
    for (std::int32_t i = 0; i < given.length; ++i) sum += values[i] - values[i];
    if (sum == 0) continue;
    return fail(ErrorCode::invalidPositions,
                fmt::format("point {} has a value that is NaN or infinite; give finite numbers", p), p,
                p < vertices ? ElementKind::vertex : ElementKind::other);
  }
  return {};
}

}  // namespace honeycomb::Capi
