#pragma once

#include "far/tables/level_table.h"
#include "far/tables/stencil_table.h"
#include "osd/piece.h"

/// The kernels of osd/plain_kernels.h on vectors, in single precision: the same bits by the best instructions of the
/// CPU the program runs on. A call touches nothing that the described values of its range don't need: the source no
/// further than Piece::narrowPoint allows, the target in its own outputs only.
namespace honeycomb::Osd::Simd {

void circulantFaces(const Far::LevelTable& table, const Far::CirculantBatch& batch, const Piece<float>& piece,
                    std::int64_t begin, std::int64_t end);
void denseRows(const Far::LevelTable& table, const Far::DenseRows& batch, const Piece<float>& piece, std::int64_t begin,
               std::int64_t end);
void projectedFaces(const Far::LevelTable& table, const Piece<float>& piece, std::int64_t begin, std::int64_t end);
void looseRows(const Far::LevelTable& table, const Piece<float>& piece, std::int64_t begin, std::int64_t end);
void stencilRows(const Far::StencilTable& table, Far::StencilWeights which, const Piece<float>& piece,
                 std::int64_t begin, std::int64_t end);

}  // namespace honeycomb::Osd::Simd
