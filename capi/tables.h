#pragma once

#include <cstdint>
#include <optional>

#include "capi/context.h"
#include "far/base/result.h"
#include "far/tables/normal_rule.h"
#include "far/tables/refinement.h"
#include "far/tables/tile_table.h"

/// Immutable once made.
struct hc_tables {
  honeycomb::Capi::ContextHandle context;
  honeycomb::Far::Refinement refinement;
  hc_normals normals = HC_NORMALS_NONE;
  bool limits = false;
  std::optional<honeycomb::Far::TileTable> tiles;
  std::optional<honeycomb::Far::NormalTable> fastNormals;  ///< for evaluation without tiles
};

namespace honeycomb::Capi {

inline const Context* contextIn(const hc_tables* tables) {
  return tables != nullptr ? tables->context.get() : nullptr;
}

/// Is there such a level? Errors: invalidOption, for NULL too.
Result<void> checkLevel(const hc_tables* tables, std::int32_t level);

}  // namespace honeycomb::Capi
