#include "osd/buffer_descriptor.h"

#include <fmt/format.h>

namespace honeycomb::Osd {

Result<void> checkDescriptor(const BufferDescriptor& desc, std::int64_t size, std::int64_t count, const char* what) {
  if (desc.offset < 0 || desc.length < 1 || desc.stride < desc.length) {
    return fail(
        ErrorCode::invalidOption,
        fmt::format("{}: a buffer of offset {}, length {}, stride {} makes no sense; offset must be at least 0, "
                    "length at least 1 and stride at least the length",
                    what, desc.offset, desc.length, desc.stride));
  }
  if (size < desc.extent(count)) {
    return fail(ErrorCode::invalidOption, fmt::format("{}: {} points need {} numbers, the buffer holds {}", what, count,
                                                      desc.extent(count), size));
  }
  return {};
}

}  // namespace honeycomb::Osd
