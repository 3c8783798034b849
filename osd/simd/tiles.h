#pragma once

#include "far/tables/tile_table.h"
#include "osd/tile_kernels.h"
#include "osd/tile_normal_kernels.h"

namespace honeycomb::Osd::Simd {

/// A tile in single precision by the vectors of this machine, for up to four values a point: what
/// Kernels::evaluateTile gives, bit for bit.
void evaluateTile(const Far::TileTable& table, const Far::Tile& tile, const Kernels::TileViews<float>& views,
                  std::int32_t length);

/// The normals of tile number `tile`, from its own points: Kernels::evaluateTileNormals, bit for bit.
void evaluateTileNormals(const Far::TileTable& table, std::int32_t tile, const float* points,
                         const Kernels::NormalViews<float>& views);

}  // namespace honeycomb::Osd::Simd
