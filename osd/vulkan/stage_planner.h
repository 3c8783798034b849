#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "far/base/result.h"
#include "osd/buffer_descriptor.h"
#include "osd/vulkan/core.h"
#include "osd/vulkan/kernels.h"
#include "osd/vulkan/table_image.h"

namespace honeycomb::Osd {

/// The dispatches that apply one table to one layout of points, and how many bytes they touch.
struct StagePlan {
  std::vector<std::vector<Dispatch>> steps;  ///< a barrier after each
  std::uint64_t sourceBytes = 0;             ///< read, from the range's begin
  std::uint64_t targetBytes = 0;             ///< written
  std::uint64_t normalBytes = 0;             ///< the same of unit normals; 0: none
  std::uint64_t partialBytes = 0;            ///< scratch for the sums of large faces
};

/// Points in a buffer.
struct PointLayout {
  BufferDescriptor desc;
  std::int64_t count = 0;
};

/// A part of a section that can be bound: the wanted entries begin `first` entries into the range.
struct Slice {
  BoundRange range;
  std::uint32_t first = 0;
};

/// A part of the target that can be bound, in numbers.
struct Window {
  std::uint64_t begin = 0;
  std::uint64_t size = 0;
};

/// Items, such as the faces of a batch, one after the other.
struct ItemRange {
  std::int64_t begin = 0, end = 0;
};

/// The points that items write: item g those from first + g*each on, `each` of them.
struct ItemOutputs {
  std::int64_t first = 0, each = 1;
};

/// What a dispatch can hold of rows that are compressed: rows, and entries of theirs.
struct RowCapacity {
  std::int64_t rows = 0, entries = 0;
};

/// The end of the rows from `begin` on that go together, one at least; row r has the entries offsets[r] ..
/// offsets[r + 1] - 1.
std::int64_t endOfRows(std::span<const std::int32_t> offsets, std::int64_t begin, const RowCapacity& capacity);

/// The limits of a device applied: storage buffers are bound in ranges of at most a page, so tables are cut into
/// slices, targets into windows, and sources are bound as several pages.
///
///     target   | page 0 | page 1 | page 2 |     one window a page; a dispatch writes what falls into its window
///     source   | page 0 | page 1 | page 2 |     all bound at once, at most kSourcePages
///     indices  |   slice 0  |  slice 1 |        as many faces or rows as fit
class StagePlanner {
 public:
  StagePlanner(const VulkanLimits& limits, const PointLayout& source, const PointLayout& target)
      : limits_(limits), source_(source), target_(target) {}

  /// tooLarge when the points can't be reached: a source of more than kSourcePages pages, 2^32 numbers or more.
  Result<void> check() const;

  const VulkanLimits& limits() const { return limits_; }
  const PointLayout& source() const { return source_; }
  const PointLayout& target() const { return target_; }
  std::uint64_t sourceBytes() const { return bytesOf(source_); }
  std::uint64_t targetBytes() const { return bytesOf(target_); }
  /// Bytes of a buffer with this layout.
  static std::uint64_t bytesOf(const PointLayout& layout) {
    return static_cast<std::uint64_t>(layout.desc.extent(layout.count)) * sizeof(float);
  }

  /// Entries of a section that a slice can always hold.
  std::int64_t sliceCapacity(const Section& section) const;
  /// The slice of [first, first + count); tooLarge when it passes a page.
  Result<Slice> slice(const Section& section, std::int64_t first, std::int64_t count) const;

  /// The windows of a layout that hold values of the points first..last.
  std::vector<Window> windows(const PointLayout& layout, std::int64_t first, std::int64_t last) const;
  /// The items of `range` that have values in the window.
  ItemRange itemsIn(const Window& window, const ItemOutputs& outputs, ItemRange range) const;
  /// The number of a point's first value.
  static std::uint64_t number(const PointLayout& layout, std::int64_t point) {
    return static_cast<std::uint64_t>(layout.desc.offset) +
           static_cast<std::uint64_t>(point) * static_cast<std::uint64_t>(layout.desc.stride);
  }

  /// A dispatch with the constants that source and target determine.
  Dispatch dispatch(Kernel kernel) const;
  /// Binds a window of the target.
  void bindTarget(Dispatch& dispatch, const Window& window) const;
  /// Shapes the dispatch for that many invocations; tooLarge past what a two-dimensional dispatch can hold.
  Result<void> shape(Dispatch& dispatch, std::uint64_t invocations) const;

 private:
  bool fitsPage(std::uint64_t bytes) const { return bytes <= limits_.pageBytes; }

  VulkanLimits limits_;
  PointLayout source_;
  PointLayout target_;
};

/// The range of a slot.
inline BoundRange& rangeOf(Dispatch& dispatch, Slot slot) {
  return dispatch.ranges[static_cast<std::size_t>(slot)];
}

}  // namespace honeycomb::Osd
