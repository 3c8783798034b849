#include "io/checksum.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace honeycomb::Io {

std::uint64_t checksum(std::span<const std::byte> bytes) {
  return XXH3_64bits(bytes.data(), bytes.size());
}

struct Checksum::State {
  XXH3_state_t hash;
};

Checksum::Checksum() : state_(std::make_unique<State>()) {
  XXH3_64bits_reset(&state_->hash);
}
Checksum::Checksum(Checksum&&) noexcept = default;
Checksum& Checksum::operator=(Checksum&&) noexcept = default;
Checksum::~Checksum() = default;

void Checksum::add(std::span<const std::byte> bytes) {
  XXH3_64bits_update(&state_->hash, bytes.data(), bytes.size());
}

void Checksum::add(std::string_view text) {
  addValue(text.size());
  add(std::as_bytes(std::span(text)));
}

std::uint64_t Checksum::value() const {
  return XXH3_64bits_digest(&state_->hash);
}

}  // namespace honeycomb::Io
