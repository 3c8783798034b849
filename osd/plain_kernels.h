#pragma once

#include <span>

#include "far/tables/level_table.h"
#include "far/tables/limit_table.h"
#include "far/tables/stencil_table.h"
#include "osd/piece.h"

/// Plain loops over ranges of batches, in single and double precision: the reference, and what SIMD kernels leave
/// undone. Instructions of every CPU the library runs on.
namespace honeycomb::Osd::Plain {

/// Faces begin .. end-1 of a batch.
template <class Real>
void circulantFaces(const Far::LevelTable& table, const Far::CirculantBatch& batch, const Piece<Real>& piece,
                    std::int64_t begin, std::int64_t end);

/// Rows begin .. end-1 of a batch.
template <class Real>
void denseRows(const Far::LevelTable& table, const Far::DenseRows& batch, const Piece<Real>& piece, std::int64_t begin,
               std::int64_t end);

/// Large faces begin .. end-1 of a level.
template <class Real>
void projectedFaces(const Far::LevelTable& table, const Piece<Real>& piece, std::int64_t begin, std::int64_t end);

/// Loose rows begin .. end-1 of a level.
template <class Real>
void looseRows(const Far::LevelTable& table, const Piece<Real>& piece, std::int64_t begin, std::int64_t end);

/// The sums of the large faces begin .. end-1 of a level: kPiece numbers each, of which the piece's width are written.
template <class Real>
void faceSums(const Far::LevelTable& table, const Piece<Real>& piece, std::span<Real> sums, std::int64_t begin,
              std::int64_t end);

/// Summed rows begin .. end-1 of a level, from the sums of all its large faces.
template <class Real>
void summedRows(const Far::LevelTable& table, const Piece<Real>& piece, std::span<const Real> sums, std::int64_t begin,
                std::int64_t end);

/// Rows begin .. end-1, row r to point r.
template <class Real>
void stencilRows(const Far::StencilTable& table, Far::StencilWeights which, const Piece<Real>& piece,
                 std::int64_t begin, std::int64_t end);

}  // namespace honeycomb::Osd::Plain
