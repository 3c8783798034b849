#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tests/support/random.h"

namespace honeycomb::Fuzz {

using File = std::vector<std::uint8_t>;

/// One of the files with one to four changes: bits, bytes and numbers, pieces left out, put in twice or taken from
/// another of the files.
File mutated(std::span<const File> files, Test::Random& random);

}  // namespace honeycomb::Fuzz
