#include "far/tables/tile_join.h"

#include <gtest/gtest.h>

#include <vector>

namespace honeycomb::Test {
namespace {

/// One tile of one step of two stages, of which the first is not written, over three indices.
Far::TileParts tilePart() {
  Far::TileParts part;
  part.tiles.resize(1, {});
  part.tiles[0].firstImport = 0;
  part.tiles[0].firstStep = 0;
  part.steps.resize(1, {});
  part.stages.resize(2, {});
  part.stages[0].firstOutput = -1;
  part.stages[1].firstOutput = 2;
  part.imports = {4, 5};
  part.indices = {7, 8, 9};
  part.outputs = {10, 20, 30};
  part.written = {1, 2, 3, 4};
  part.normals.tiles.resize(1, {});
  part.normals.frames.resize(1, {});
  part.normals.indices = {1, 2};
  part.normals.firstFace = {-1, 1};
  part.normals.faces = {3, 4, 5};
  part.normals.born.push_back({5, 6});
  part.limits.tiles.resize(1, {});
  part.limits.frames.resize(1, {});
  part.limits.indices = {6, 7, 8, 9};
  part.limits.ringTiles.resize(1, {});
  part.limits.rings.resize(1, {});
  part.limits.windows = {1, 2, 3};
  return part;
}

Far::TileTable joinedTwice(Far::TileOrder order) {
  Far::TileTable table;
  table.order = order;
  std::vector<Far::TileParts> parts{tilePart(), tilePart()};
  EXPECT_TRUE(Far::joinTiles(parts, table).has_value());
  for (const Far::TileParts& part : parts) EXPECT_TRUE(part.indices.empty());
  return table;
}

TEST(TileJoin, MovesPlacesOnByWhatStandsBefore) {
  const Far::TileTable table = joinedTwice(Far::TileOrder::levels);
  EXPECT_EQ(table.tiles[1].firstImport, 2);
  EXPECT_EQ(table.tiles[1].firstStep, 1);
  EXPECT_EQ(table.steps[1].firstIndex, 3);
  EXPECT_EQ(table.steps[1].firstStage, 2);
  EXPECT_EQ(table.steps[1].firstRow, 0);
  EXPECT_EQ(table.stages[1].firstOutput, 2);
  EXPECT_EQ(table.stages[2].firstOutput, -1) << "what is not written has no place";
  EXPECT_EQ(table.stages[3].firstOutput, 5);
  EXPECT_EQ(table.imports, (Array<std::int32_t>{4, 5, 4, 5}));
  EXPECT_EQ(table.outputs, (Array<std::int32_t>{10, 20, 30, 10, 20, 30}));
  EXPECT_EQ(table.normals.frames[1].firstIndex, 2);
  EXPECT_EQ(table.normals.firstFace, (Array<std::int32_t>{-1, 1, -1, 4}));
  EXPECT_EQ(table.normals.born[1].firstNormal, 5) << "numbers of a tile stay";
  EXPECT_EQ(table.normals.born[1].firstWeight, 6);
  EXPECT_EQ(table.limits.tiles[1].first, 1);
  EXPECT_EQ(table.limits.frames[1].firstIndex, 4);
  EXPECT_EQ(table.limits.frames[1].firstOutput, 3);
  EXPECT_EQ(table.limits.ringTiles[1].first, 1);
  EXPECT_EQ(table.limits.rings[1].step, 1);
  EXPECT_EQ(table.limits.rings[1].firstIndex, 3);
}

TEST(TileJoin, CountsOutputsAsTheyAreWrittenInTheOrderOfTiles) {
  const Far::TileTable table = joinedTwice(Far::TileOrder::tiles);
  EXPECT_EQ(table.stages[3].firstOutput, 6);
  EXPECT_EQ(table.limits.frames[1].firstOutput, 4);
}

TEST(TileJoin, RefusesMoreThanCanBeToldApart) {
  std::vector<Far::TileParts> parts{tilePart(), tilePart()};
  Far::TileTable table;
  const auto refused = Far::joinTiles(parts, table, 7);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::tooLarge);
  EXPECT_TRUE(table.indices.empty());
  EXPECT_TRUE(Far::joinTiles(parts, table, 8).has_value());
}

}  // namespace
}  // namespace honeycomb::Test
