#pragma once

#include <cstdint>
#include <type_traits>

#include "far/tables/level_table.h"
#include "far/tables/limit_table.h"
#include "far/tables/tile_table.h"
#include "io/table_format.h"

/// Which array of a table is which section: the one list that writes and reads them. visit(array, table, values) is
/// called with each; a table that isn't const takes what the visit has left in the values.
namespace honeycomb::Io {

template <class Table, class Visit>
void visitArrays(Table& table, std::uint32_t number,
                 const Visit& visit) requires std::is_same_v<std::remove_const_t<Table>, Far::LevelTable> {
  using enum TableArray;
  LevelRecord counts{table.sourceCount,
                     table.targetCount,
                     table.loose.firstIndex,
                     table.loose.firstWeight,
                     table.summed.rows.firstIndex,
                     table.summed.rows.firstWeight,
                     table.summed.firstShare,
                     0};
  visit(levelCounts, number, counts);
  if constexpr (!std::is_const_v<Table>) {
    table.sourceCount = counts.source;
    table.targetCount = counts.target;
    table.loose.firstIndex = counts.looseIndex;
    table.loose.firstWeight = counts.looseWeight;
    table.summed.rows.firstIndex = counts.summedIndex;
    table.summed.rows.firstWeight = counts.summedWeight;
    table.summed.firstShare = counts.firstShare;
  }
  visit(circulants, number, table.circulants);
  visit(projected, number, table.projected);
  visit(dense, number, table.dense);
  visit(looseOutputs, number, table.loose.outputs);
  visit(looseOffsets, number, table.loose.offsets);
  visit(summedOutputs, number, table.summed.rows.outputs);
  visit(summedOffsets, number, table.summed.rows.offsets);
  visit(shareOffsets, number, table.summed.shareOffsets);
  visit(shareFaces, number, table.summed.faces);
  visit(indices, number, table.indices);
  visit(weights, number, table.weights);
  visit(weightsSingle, number, table.weightsSingle);
}

template <class Rows, class Visit>
void visitArrays(Rows& rows, std::uint32_t number,
                 const Visit& visit) requires std::is_same_v<std::remove_const_t<Rows>, Far::LimitRows> {
  using enum TableArray;
  LimitRecord counts{rows.sourceCount, rows.elementCount};
  visit(limitCounts, number, counts);
  if constexpr (!std::is_const_v<Rows>) {
    rows.sourceCount = counts.source;
    rows.elementCount = counts.elements;
  }
  visit(limitBatches, number, rows.batches);
  visit(limitElements, number, rows.elements);
  visit(limitIndices, number, rows.indices);
  visit(limitWeights, number, rows.weights);
  visit(limitWeightsSingle, number, rows.weightsSingle);
}

template <class Limits, class Visit>
void visitArrays(Limits& limits,
                 const Visit& visit) requires std::is_same_v<std::remove_const_t<Limits>, Far::LimitTable> {
  visitArrays(limits.faces, kFaceLimits, visit);
  visitArrays(limits.child, kLimitChild, visit);
  visitArrays(limits.vertices, kVertexLimits, visit);
  visitArrays(limits.verticesHere, kVertexLimitsHere, visit);
}

template <class Normals, class Visit>
void visitNormals(Normals& normals, const Visit& visit) {
  using enum TableArray;
  visit(normalTiles, 0, normals.tiles);
  visit(normalImports, 0, normals.imports);
  visit(normalFrames, 0, normals.frames);
  visit(normalIndices, 0, normals.indices);
  visit(normalFirstFace, 0, normals.firstFace);
  visit(normalFaces, 0, normals.faces);
  visit(normalBorn, 0, normals.born);
  visit(normalWeights, 0, normals.weights);
  visit(normalWeightsSingle, 0, normals.weightsSingle);
  visit(normalSharedOffsets, 0, normals.sharedOffsets);
  visit(normalSharedFaces, 0, normals.sharedFaces);
  std::uint32_t level = kSharedNormals;
  for (auto& rows : normals.shared) visitArrays(rows, level++, visit);
}

template <class Limits, class Visit>
void visitTileLimits(Limits& limits, const Visit& visit) {
  using enum TableArray;
  visit(exactTiles, 0, limits.tiles);
  visit(exactFrames, 0, limits.frames);
  visit(exactIndices, 0, limits.indices);
  visit(exactRingTiles, 0, limits.ringTiles);
  visit(exactRings, 0, limits.rings);
  visit(exactWindows, 0, limits.windows);
  visit(exactWeights, 0, limits.weights);
  visit(exactWeightsSingle, 0, limits.weightsSingle);
  visitArrays(limits.shared, kSharedLimits, visit);
}

/// What a TileTable has beside its arrays, as a file keeps it.
TileRecord recordOf(const Far::TileTable& tiles);
/// The other way round; sets and levels of normals are made, empty. False for counts that no table has.
bool setRecord(const TileRecord& record, Far::TileTable& tiles);

/// All but the counts, which decide what there is.
template <class Tiles, class Visit>
void visitArrays(Tiles& table, const Visit& visit) requires std::is_same_v<std::remove_const_t<Tiles>, Far::TileTable> {
  using enum TableArray;
  visit(tilePointCount, 0, table.pointCount);
  visit(tiles, 0, table.tiles);
  visit(tileSteps, 0, table.steps);
  visit(tileStages, 0, table.stages);
  visit(tileImports, 0, table.imports);
  visit(tileIndices, 0, table.indices);
  visit(tileRows, 0, table.rows);
  visit(tileOutputs, 0, table.outputs);
  visit(tileWritten, 0, table.written);
  visit(tileWeights, 0, table.weights);
  visit(tileWeightsSingle, 0, table.weightsSingle);
  std::uint32_t number = kSharedSets;
  for (auto& set : table.shared) {
    visit(sharedFirst, number, set.firstPoint);
    visit(sharedWritten, number, set.written);
    visitArrays(set.table, number++, visit);
  }
  if (table.normalKind == Far::TileNormalKind::fast) visitNormals(table.normals, visit);
  if (table.normalKind == Far::TileNormalKind::exact) visitTileLimits(table.limits, visit);
}

}  // namespace honeycomb::Io
