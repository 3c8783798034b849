#include "io/mdd_writer.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>

#include "io/written_frames.h"

namespace honeycomb::Io {
namespace {

constexpr std::uint32_t bigEndian(std::uint32_t word) {
  if constexpr (std::endian::native == std::endian::big) return word;
  return (word << 24U) | ((word & 0xFF00U) << 8U) | ((word >> 8U) & 0xFF00U) | (word >> 24U);
}

void appendWord(std::uint32_t word, std::vector<std::byte>& bytes) {
  const std::uint32_t stored = bigEndian(word);
  const auto four = std::as_bytes(std::span(&stored, 1));
  bytes.insert(bytes.end(), four.begin(), four.end());
}

float timeOf(const FrameInfo& info, std::int32_t f, double unitsPerSecond) {
  return static_cast<float>((double{info.start} + f * double{info.rate}) / unitsPerSecond);
}

std::vector<std::byte> mddHeader(const FrameInfo& info, double unitsPerSecond) {
  std::vector<std::byte> bytes;
  appendWord(static_cast<std::uint32_t>(info.frameCount), bytes);
  appendWord(static_cast<std::uint32_t>(info.pointCount), bytes);
  for (std::int32_t f = 0; f < info.frameCount; ++f)
    appendWord(std::bit_cast<std::uint32_t>(timeOf(info, f, unitsPerSecond)), bytes);
  return bytes;
}

class MddLayout : public FrameLayout {
 public:
  MddLayout(const FrameInfo& info, double unitsPerSecond)
      : FrameLayout(info, mddHeader(info, unitsPerSecond),
                    std::int64_t{info.pointCount} * 3 * std::int64_t{sizeof(float)}) {}
  std::span<const std::byte> encode(std::int32_t /*f*/, std::span<const float> points,
                                    std::vector<std::byte>& storage) const override {
    storage.resize(points.size_bytes());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::uint32_t word = bigEndian(std::bit_cast<std::uint32_t>(points[i]));
      std::memcpy(storage.data() + 4 * i, &word, sizeof word);
    }
    return storage;
  }
};

}  // namespace

Result<std::shared_ptr<const FrameLayout>> mddLayout(std::string_view name, const FrameInfo& info,
                                                     double unitsPerSecond) {
  if (Result<void> sound = checkCounts(name, "an MDD cache", info); !sound) return tl::unexpected<Error>(sound.error());
  const float first = timeOf(info, 0, unitsPerSecond), last = timeOf(info, info.frameCount - 1, unitsPerSecond);
  const bool ascend = std::isfinite(first) && std::isfinite(last) && (last > first || info.frameCount == 1);
  if (!ascend)
    return fail(ErrorCode::invalidOption,
                fmt::format("{}: frames from {} s to {} s have no times in an MDD cache; give a positive number of "
                            "frames a second",
                            name, first, last));
  return std::make_shared<const MddLayout>(info, unitsPerSecond);
}

}  // namespace honeycomb::Io
