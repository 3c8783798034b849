#pragma once

#include <cstdint>
#include <span>

#include "far/base/result.h"

namespace honeycomb::Osd {

/// Where a primvar of `length` values lies in a buffer of numbers, as in OpenSubdiv:
///     | offset |  length  |  ...        |  length  |  ...
///              |<--------- stride ----->|<--------- stride -----
///     point:   0                        1
struct BufferDescriptor {
  std::int32_t offset = 0;  ///< numbers before the first point's values
  std::int32_t length = 3;  ///< values a point: 3 for positions, 2 for uv, anything from 1
  std::int32_t stride = 3;  ///< numbers from one point to the next, at least length
  bool operator==(const BufferDescriptor&) const = default;

  /// Numbers a buffer must hold for `points` points.
  constexpr std::int64_t extent(std::int64_t points) const {
    return points == 0 ? offset : offset + (points - 1) * stride + length;
  }
};

/// Points to read: `data` must hold desc.extent(count) numbers for as many points as the table reads.
template <class Real>
struct Points {
  std::span<const Real> data;
  BufferDescriptor desc;
};

/// Points to write; only the described values are touched.
template <class Real>
struct PointsOut {
  std::span<Real> data;
  BufferDescriptor desc;
};

/// Is the descriptor sound (length >= 1, stride >= length, offset >= 0), and does a buffer of `size` numbers hold
/// `count` points of it? `what` names the buffer in the message.
Result<void> checkDescriptor(const BufferDescriptor& desc, std::int64_t size, std::int64_t count, const char* what);

}  // namespace honeycomb::Osd
