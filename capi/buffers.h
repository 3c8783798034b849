#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "capi/structs.h"
#include "osd/buffer_descriptor.h"

/// The caller's buffers of points: whether they are sound, and apart where they must be.
namespace honeycomb::Capi {

inline Osd::BufferDescriptor descriptorOf(std::int32_t offset, std::int32_t length, std::int32_t stride) {
  return {offset, length, stride};
}

inline Osd::Points<float> pointsOf(const hc_points& given) {
  return {{given.data, given.size}, descriptorOf(given.offset, given.length, given.stride)};
}

inline Osd::PointsOut<float> pointsOf(const hc_points_out& given) {
  return {{given.data, given.size}, descriptorOf(given.offset, given.length, given.stride)};
}

/// Does the buffer (hc_points, hc_points_out) hold so many points? Errors: invalidOption.
template <class Given>
Result<void> checkBuffer(const Given* given, std::int64_t points, const char* what) {
  if (given == nullptr || given->data == nullptr)
    return refuse(fmt::format("{} is NULL; give a buffer of {} points", what, points));
  constexpr std::size_t kMost = std::numeric_limits<std::int64_t>::max();
  return Osd::checkDescriptor(descriptorOf(given->offset, given->length, given->stride),
                              static_cast<std::int64_t>(std::min(given->size, kMost)), points, what);
}

/// The memory of described points.
struct Extent {
  std::uintptr_t begin = 0, end = 0;
  std::int64_t length = 0, stride = 0;
};

/// Of a buffer that holds so many.
template <class Given>
Extent extentOf(const Given& given, std::int64_t points) {
  const auto first = reinterpret_cast<std::uintptr_t>(given.data + given.offset);
  const std::int64_t numbers = points == 0 ? 0 : (points - 1) * given.stride + given.length;
  return {first, first + static_cast<std::uintptr_t>(numbers) * sizeof(float), given.length, given.stride};
}

/// Are what is read and one or two things that are written apart? Those that are written may be interleaved.
/// Errors: invalidOption.
Result<void> checkApart(const Extent& read, const Extent& first, const Extent& second);

/// Errors: invalidPositions, naming the point; the first `vertices` are vertices of the caller's mesh.
Result<void> checkFinite(const hc_points& given, std::int64_t points, std::int64_t vertices);

}  // namespace honeycomb::Capi
