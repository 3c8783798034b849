#include "tests/support/sha256.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace honeycomb::Test {
namespace {

using State = std::array<std::uint32_t, 8>;

/// The first `count` primes.
template <std::size_t count>
std::array<std::uint32_t, count> primes() {
  std::array<std::uint32_t, count> result{};
  std::size_t found = 0;
  for (std::uint32_t n = 2; found < count; ++n) {
    bool prime = true;
    for (std::size_t i = 0; i < found; ++i) prime = prime && n % result[i] != 0;
    if (prime) result[found++] = n;
  }
  return result;
}

/// The first 32 bits of the fractional part: the standard's constants are those of roots of primes.
std::uint32_t fraction(long double x) {
  return static_cast<std::uint32_t>((x - std::floor(x)) * 0x1p32L);
}

std::array<std::uint32_t, 64> roundConstants() {
  std::array<std::uint32_t, 64> k{};
  const auto p = primes<64>();
  for (std::size_t i = 0; i < k.size(); ++i) k[i] = fraction(std::cbrt(static_cast<long double>(p[i])));
  return k;
}

State initialState() {
  State h{};
  const auto p = primes<8>();
  for (std::size_t i = 0; i < h.size(); ++i) h[i] = fraction(std::sqrt(static_cast<long double>(p[i])));
  return h;
}

std::array<std::uint32_t, 64> schedule(std::string_view block) {
  std::array<std::uint32_t, 64> w{};
  for (std::size_t i = 0; i < 64; ++i) w[i / 4] = w[i / 4] << 8 | static_cast<unsigned char>(block[i]);
  for (std::size_t i = 16; i < 64; ++i) {
    const std::uint32_t s0 = std::rotr(w[i - 15], 7) ^ std::rotr(w[i - 15], 18) ^ w[i - 15] >> 3;
    const std::uint32_t s1 = std::rotr(w[i - 2], 17) ^ std::rotr(w[i - 2], 19) ^ w[i - 2] >> 10;
    w[i] = w[i - 16] + s0 + w[i - 7] + s1;
  }
  return w;
}

void absorb(State& h, std::string_view block) {
  static const std::array<std::uint32_t, 64> k = roundConstants();
  const auto w = schedule(block);
  State s = h;
  for (std::size_t i = 0; i < 64; ++i) {
    const std::uint32_t s1 = std::rotr(s[4], 6) ^ std::rotr(s[4], 11) ^ std::rotr(s[4], 25);
    const std::uint32_t choice = (s[4] & s[5]) ^ (~s[4] & s[6]);
    const std::uint32_t s0 = std::rotr(s[0], 2) ^ std::rotr(s[0], 13) ^ std::rotr(s[0], 22);
    const std::uint32_t majority = (s[0] & s[1]) ^ (s[0] & s[2]) ^ (s[1] & s[2]);
    const std::uint32_t a = s[7] + s1 + choice + k[i] + w[i];
    s = {a + s0 + majority, s[0], s[1], s[2], s[3] + a, s[4], s[5], s[6]};
  }
  for (std::size_t i = 0; i < 8; ++i) h[i] += s[i];
}

}  // namespace

std::string sha256(std::string_view bytes) {
  std::string padded(bytes);
  padded.push_back(static_cast<char>(0x80));
  while (padded.size() % 64 != 56) padded.push_back(0);
  const std::uint64_t bits = std::uint64_t{8} * bytes.size();
  for (int shift = 56; shift >= 0; shift -= 8) padded.push_back(static_cast<char>(bits >> shift & 0xff));

  State h = initialState();
  for (std::size_t i = 0; i < padded.size(); i += 64) absorb(h, std::string_view(padded).substr(i, 64));

  std::string text;
  for (const std::uint32_t word : h) {
    for (int shift = 28; shift >= 0; shift -= 4) text.push_back("0123456789abcdef"[word >> shift & 0xf]);
  }
  return text;
}

}  // namespace honeycomb::Test
