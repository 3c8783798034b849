#include "tests/fuzz/mutate.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace honeycomb::Fuzz {
namespace {

/// Where counts and indices go wrong.
constexpr std::array<std::int32_t, 10> kNumbers = {
    0, -1, 1, 127, -128, 1 << 16, 1 << 20, 16777216, -2147483647 - 1, 2147483647};

/// A piece of at most 16 bytes.
struct Piece {
  Piece(const File& file, Test::Random& random)
      : begin(random.below(file.size())), size(random.between(1, std::min<std::size_t>(16, file.size() - begin))) {}
  std::size_t begin, size;
};

void flipBit(File& file, Test::Random& random) {
  file[random.below(file.size())] ^= static_cast<std::uint8_t>(1U << random.below(8));
}

void setByte(File& file, Test::Random& random) {
  file[random.below(file.size())] = static_cast<std::uint8_t>(random.below(256));
}

void setNumber(File& file, Test::Random& random) {
  const std::int32_t number = kNumbers[random.below(kNumbers.size())];
  std::array<std::uint8_t, sizeof(number)> bytes{};
  std::memcpy(bytes.data(), &number, sizeof(number));
  if (random.chance(0.5)) std::ranges::reverse(bytes);
  const std::size_t place = random.below(file.size());
  std::copy_n(bytes.begin(), std::min(bytes.size(), file.size() - place),
              file.begin() + static_cast<std::ptrdiff_t>(place));
}

void leaveOut(File& file, Test::Random& random) {
  const Piece piece(file, random);
  const auto from = file.begin() + static_cast<std::ptrdiff_t>(piece.begin);
  file.erase(from, from + static_cast<std::ptrdiff_t>(piece.size));
}

void putIn(File& file, const File& from, Test::Random& random) {
  const Piece piece(from, random);
  const File bytes(from.begin() + static_cast<std::ptrdiff_t>(piece.begin),
                   from.begin() + static_cast<std::ptrdiff_t>(piece.begin + piece.size));
  file.insert(file.begin() + static_cast<std::ptrdiff_t>(random.below(file.size() + 1)), bytes.begin(), bytes.end());
}

void change(File& file, std::span<const File> files, Test::Random& random) {
  if (file.empty()) return;
  const File& other = files[random.below(files.size())];
  switch (random.below(8)) {
    case 0:
    case 1:
      return flipBit(file, random);
    case 2:
      return setByte(file, random);
    case 3:
    case 4:
      return setNumber(file, random);
    case 5:
      return leaveOut(file, random);
    case 6:
      return putIn(file, File(file), random);
    default:
      return putIn(file, other.empty() ? File(file) : other, random);
  }
}

}  // namespace

File mutated(std::span<const File> files, Test::Random& random) {
  File file = files[random.below(files.size())];
  for (std::size_t changes = random.between(1, 4); changes > 0; --changes) change(file, files, random);
  return file;
}

}  // namespace honeycomb::Fuzz
