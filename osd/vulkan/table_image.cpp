#include "osd/vulkan/table_image.h"

#include <utility>

namespace honeycomb::Osd {

Section TableImage::add(std::vector<std::uint32_t> values) {
  owned_.push_back(std::move(values));
  return add(std::as_bytes(std::span<const std::uint32_t>(owned_.back())));
}

Section TableImage::add(std::span<const std::byte> bytes) {
  const Section section{size_, static_cast<std::int64_t>(bytes.size() / sizeof(std::uint32_t))};
  pieces_.push_back({size_, bytes});
  size_ += (bytes.size() + alignment_ - 1) / alignment_ * alignment_;
  return section;
}

}  // namespace honeycomb::Osd
