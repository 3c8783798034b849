#include "osd/tile_size.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <limits>

#include "far/base/parallel.h"

namespace honeycomb::Osd {

namespace {

// In bytes; 0 where the system doesn't tell. Linux alone says what one processor reaches: sysconf() adds up the
// last-level caches of the whole machine.
std::int64_t cacheSize(int level) {
  std::ifstream file(fmt::format("/sys/devices/system/cpu/cpu0/cache/index{}/size", level));
  std::int64_t size = 0;
  char unit = 0;
  if (!(file >> size >> unit) || size <= 0 || size > std::numeric_limits<std::int32_t>::max()) return 0;
  return unit == 'K' ? size << 10 : unit == 'M' ? size << 20 : 0;
}

}  // namespace

std::int32_t tilePoints() {
  constexpr std::int64_t kPointBytes = 16;
  constexpr std::int64_t kUnknown = 8192 * 2 * kPointBytes;
  static const std::int64_t known = cacheSize(2);
  const std::int64_t cache = known > 0 ? known : kUnknown;
  return static_cast<std::int32_t>(std::clamp<std::int64_t>(cache / 2 / kPointBytes, 4096, 32768));
}

std::int64_t cachedBytes() {
  static const std::int64_t cache = cacheSize(3);
  return cache > 0 ? cache / 4 * 3 : std::numeric_limits<std::int64_t>::max();
}

std::int64_t streamedBytes() {
  static const std::int64_t cache = cacheSize(3);
  return std::clamp(cache / 8 * 5, std::int64_t{16} << 20, std::int64_t{20} << 20);
}

Far::TileOptions cpuTileOptions(Far::TileNormalKind normals) {
  constexpr std::int32_t kTilesAThread = 8;
  return {.scratchPoints = tilePoints(),
          .fewestTiles = kTilesAThread * Parallel::threadCount(),
          .normals = normals,
          .places = Far::TilePlaces::fours};
}

}  // namespace honeycomb::Osd
