#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace honeycomb::Io::Test {

/// A PC2 header byte by byte, independent of the library's own.
inline std::string pc2Header(std::int32_t points, std::int32_t frames, std::int32_t version = 1, float start = 0.5F,
                             float rate = 0.25F) {
  std::string bytes("POINTCACHE2\0", 12);
  std::array<char, 20> numbers{};
  std::memcpy(numbers.data(), &version, 4);
  std::memcpy(numbers.data() + 4, &points, 4);
  std::memcpy(numbers.data() + 8, &start, 4);
  std::memcpy(numbers.data() + 12, &rate, 4);
  std::memcpy(numbers.data() + 16, &frames, 4);
  return bytes.append(numbers.data(), numbers.size());
}

inline std::string bytesOf(std::span<const float> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

}  // namespace honeycomb::Io::Test
