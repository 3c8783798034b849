#include "apps/cli/frame_tiles.h"

#include "apps/cli/memory.h"

namespace honeycomb::Cli {
namespace {

bool madeOfFaces(const Far::Refinement& refinement) {
  std::int64_t all = 0, ofFaces = 0;
  for (std::int32_t k = 1; k <= refinement.levelCount(); ++k) {
    const Far::LevelTable& table = refinement.level(k).table;
    all += table.targetCount;
    for (const Far::CirculantBatch& batch : table.circulants) ofFaces += std::int64_t{batch.sides} * batch.faceCount;
  }
  return 100 * ofFaces >= kTileFacePoints * all;
}

}  // namespace

bool tilesPay(const Far::Refinement& refinement, std::int32_t frames, int atOnce) {
  const std::int64_t points = refinement.last().pointCount();
  if (frames < kTileFrames || points < kTilePoints || !madeOfFaces(refinement)) return false;
  const std::int64_t pointBytes = kTileBuildBytes + std::int64_t{atOnce} * 3 * std::int64_t{sizeof(float)};
  return points * pointBytes <= availableMemory();
}

}  // namespace honeycomb::Cli
