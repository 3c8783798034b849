#include "osd/tile_size.h"

#include <unistd.h>

#include <algorithm>

#include "far/base/parallel.h"

namespace honeycomb::Osd {

std::int32_t tilePoints() {
  constexpr std::int64_t kPointBytes = 16;
  constexpr std::int64_t kUnknown = 8192 * 2 * kPointBytes;
  std::int64_t cache = 0;
#ifdef _SC_LEVEL2_CACHE_SIZE
  cache = sysconf(_SC_LEVEL2_CACHE_SIZE);
#endif
  if (cache <= 0) cache = kUnknown;
  return static_cast<std::int32_t>(std::clamp<std::int64_t>(cache / 2 / kPointBytes, 4096, 32768));
}

Far::TileOptions cpuTileOptions(Far::TileNormalKind normals) {
  constexpr std::int32_t kTilesAThread = 8;
  return {.scratchPoints = tilePoints(),
          .fewestTiles = kTilesAThread * Parallel::threadCount(),
          .normals = normals,
          .places = Far::TilePlaces::fours};
}

}  // namespace honeycomb::Osd
