#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <type_traits>

namespace honeycomb::Io {

/// 64 bits that tell contents apart (XXH3), not against malice: for files that may have been cut or changed. The same
/// on every machine.
std::uint64_t checksum(std::span<const std::byte> bytes);

/// The same of what comes in pieces. The bytes alone count, not where a piece ends.
class Checksum {
 public:
  Checksum();
  Checksum(Checksum&&) noexcept;
  Checksum& operator=(Checksum&&) noexcept;
  ~Checksum();

  void add(std::span<const std::byte> bytes);
  /// The text and its length, so that "ab", "c" isn't "a", "bc".
  void add(std::string_view text);
  /// A number, an enumeration or a struct of such without padding.
  template <class T>
  void addValue(const T& value) {
    static_assert(std::has_unique_object_representations_v<T> || std::is_floating_point_v<T>);
    add(std::as_bytes(std::span(&value, 1)));
  }
  std::uint64_t value() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace honeycomb::Io
