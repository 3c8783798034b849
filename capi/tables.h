#pragma once

#include <cstdint>
#include <optional>

#include "capi/context.h"
#include "far/base/result.h"
#include "far/tables/level_tables.h"
#include "far/tables/normal_rule.h"
#include "far/tables/refinement.h"
#include "far/tables/tile_table.h"
#include "io/table_file.h"

namespace honeycomb::Capi {

/// A table file whose indices are proven, or trusted.
struct OpenedFile {
  Io::TableFile file;
  Far::LevelTables levels;
  const Far::TileTable* tiles = nullptr;  ///< null: none
  Io::TableMesh mesh;
};

}  // namespace honeycomb::Capi

/// Immutable once made: a refinement and what was built from it, or an opened file.
struct hc_tables {
  honeycomb::Capi::ContextHandle context;
  std::optional<honeycomb::Far::Refinement> refinement;
  std::optional<honeycomb::Capi::OpenedFile> file;
  hc_normals normals = HC_NORMALS_NONE;
  std::optional<honeycomb::Far::TileTable> tiles;          ///< of the refinement
  std::optional<honeycomb::Far::NormalTable> fastNormals;  ///< of the refinement, for evaluation without tiles
  honeycomb::Io::TableInfo info;                           ///< what a file says beside its tables

  honeycomb::Far::LevelTables levels() const { return file ? file->levels : *refinement; }
  std::int32_t levelCount() const { return levels().levelCount(); }
  /// Null: none.
  const honeycomb::Far::TileTable* tileTable() const { return file ? file->tiles : tiles ? &*tiles : nullptr; }
  bool hasLimits() const { return levels().limits().faces.sourceCount > 0; }
  /// Of the last level.
  std::int32_t vertexCount() const { return file ? file->mesh.vertexCount : refinement->last().topology.vertexCount(); }
  std::int32_t faceCount() const {
    return file ? static_cast<std::int32_t>(file->mesh.faceOffsets.size()) - 1
                : refinement->last().topology.faceCount();
  }
};

namespace honeycomb::Capi {

inline const Context* contextIn(const hc_tables* tables) {
  return tables != nullptr ? tables->context.get() : nullptr;
}

/// Is there such a level? Errors: invalidOption, for NULL too.
Result<void> checkLevel(const hc_tables* tables, std::int32_t level);

}  // namespace honeycomb::Capi
