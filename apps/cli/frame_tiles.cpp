#include "apps/cli/frame_tiles.h"

#include "apps/cli/memory.h"

namespace honeycomb::Cli {
namespace {

bool madeOfFaces(const Far::LevelTables& levels) {
  std::int64_t all = 0, ofFaces = 0;
  for (std::int32_t k = 1; k <= levels.levelCount(); ++k) {
    const Far::LevelTable& table = levels.table(k);
    all += table.targetCount;
    for (const Far::CirculantBatch& batch : table.circulants) ofFaces += std::int64_t{batch.sides} * batch.faceCount;
  }
  return 100 * ofFaces >= kTileFacePoints * all;
}

}  // namespace

bool tilesPay(const Far::LevelTables& levels, std::int32_t frames, int atOnce) {
  const std::int64_t points = levels.pointCount(levels.levelCount());
  if (frames < kTileFrames || points < kTilePoints || !madeOfFaces(levels)) return false;
  const std::int64_t pointBytes = kTileBuildBytes + std::int64_t{atOnce} * 3 * std::int64_t{sizeof(float)};
  return points * pointBytes <= availableMemory();
}

}  // namespace honeycomb::Cli
