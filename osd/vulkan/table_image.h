#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "osd/vulkan/memory.h"

namespace honeycomb::Osd {

/// An array of 4-byte entries in a table's buffer.
struct Section {
  std::uint64_t offset = 0;  ///< bytes
  std::int64_t count = 0;    ///< entries
};

/// What goes into the one buffer of a table: sections, each aligned so that it can be bound by itself. Refers to the
/// arrays it is made from until it is uploaded.
class TableImage {
 public:
  explicit TableImage(std::uint64_t alignment) : alignment_(alignment) {}

  /// Values of the caller, which stay where they are.
  Section add(std::span<const std::int32_t> values) { return add(std::as_bytes(values)); }
  /// The same.
  Section add(std::span<const float> values) { return add(std::as_bytes(values)); }
  /// Keeps the values itself.
  Section add(std::vector<std::uint32_t> values);

  std::uint64_t byteCount() const { return size_; }
  std::span<const BufferPiece> pieces() const { return pieces_; }

 private:
  Section add(std::span<const std::byte> bytes);

  std::uint64_t alignment_;
  std::uint64_t size_ = 0;
  std::vector<BufferPiece> pieces_;
  std::deque<std::vector<std::uint32_t>> owned_;
};

}  // namespace honeycomb::Osd
