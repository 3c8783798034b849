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

std::int64_t pointsOf(const Far::LevelTables& levels) {
  return levels.pointCount(levels.levelCount());
}

/// Are the points made of what tiles are fast at, and is there memory to build them?
bool suitable(const Far::LevelTables& levels, int atOnce) {
  const std::int64_t pointBytes = kTileBuildBytes + std::int64_t{atOnce} * 3 * std::int64_t{sizeof(float)};
  return madeOfFaces(levels) && pointsOf(levels) * pointBytes <= availableMemory();
}

}  // namespace

bool tilesPay(const Far::LevelTables& levels, std::int32_t frames, int atOnce) {
  return frames >= kTileFrames && pointsOf(levels) >= kTilePoints && suitable(levels, atOnce);
}

bool deviceTilesPay(bool deviceIsCpu, const Far::LevelTables& levels, std::int32_t frames, int atOnce) {
  const std::int64_t points = pointsOf(levels);
  const std::int64_t cost = kDeviceTileCompileNs + kDeviceTileBuildNs * points;
  return deviceIsCpu && kDeviceTileSavedNs * points * frames >= cost && suitable(levels, atOnce);
}

}  // namespace honeycomb::Cli
