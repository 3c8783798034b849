#include "osd/plain_kernels.h"

#include "osd/cpu_kernels.h"
#include "osd/cpu_pieces.h"

namespace honeycomb::Osd::Plain {

namespace {

/// Calls body(Int<N>) with N = width where a kernel is specialised for it, else 0: mid-points and edge points, corners
/// with a central control vertex, the vertices of half-boxes, central control vertices of hexagons.
template <class Body>
void forWidth(std::int32_t width, const Body& body) {
  switch (width) {
    case 2:
      return body(Int<2>{});
    case 3:
      return body(Int<3>{});
    case 4:
      return body(Int<4>{});
    case 7:
      return body(Int<7>{});
    default:
      return body(Int<0>{});
  }
}

}  // namespace

template <class Real>
void circulantFaces(const Far::LevelTable& table, const Far::CirculantBatch& batch, const Piece<Real>& piece,
                    std::int64_t begin, std::int64_t end) {
  forPieceWidth(piece.width, [&](auto width) {
    forSides(batch.sides, [&](auto sides) {
      Kernels::circulantFaces<sides(), width()>(table, batch, piece.in, piece.out, begin, end);
    });
  });
}

template <class Real>
void denseRows(const Far::LevelTable& table, const Far::DenseRows& batch, const Piece<Real>& piece, std::int64_t begin,
               std::int64_t end) {
  forPieceWidth(piece.width, [&](auto width) {
    forWidth(batch.width, [&](auto entries) {
      Kernels::denseRows<entries(), width()>(table, batch, piece.in, piece.out, begin, end);
    });
  });
}

template <class Real>
void projectedFaces(const Far::LevelTable& table, const Piece<Real>& piece, std::int64_t begin, std::int64_t end) {
  forPieceWidth(piece.width, [&](auto width) {
    for (std::int64_t f = begin; f < end; ++f) {
      const Far::ProjectedFace& face = table.projected[at(f)];
      if (face.outputs > 0) Kernels::projectedFace<width()>(table, face, piece.in, piece.out);
    }
  });
}

template <class Real>
void looseRows(const Far::LevelTable& table, const Piece<Real>& piece, std::int64_t begin, std::int64_t end) {
  forPieceWidth(piece.width, [&](auto width) { Kernels::looseRows<width()>(table, piece.in, piece.out, begin, end); });
}

template <class Real>
void faceSums(const Far::LevelTable& table, const Piece<Real>& piece, std::span<Real> sums, std::int64_t begin,
              std::int64_t end) {
  forPieceWidth(piece.width, [&](auto width) {
    Kernels::faceSums<width()>(table, piece.in, View<Real>{sums.data(), kPiece}, begin, end);
  });
}

template <class Real>
void summedRows(const Far::LevelTable& table, const Piece<Real>& piece, std::span<const Real> sums, std::int64_t begin,
                std::int64_t end) {
  forPieceWidth(piece.width, [&](auto width) {
    Kernels::summedRows<width()>(table, piece.in, View<const Real>{sums.data(), kPiece}, piece.out, begin, end);
  });
}

template <class Real>
void stencilRows(const Far::StencilTable& table, Far::StencilWeights which, const Piece<Real>& piece,
                 std::int64_t begin, std::int64_t end) {
  forPieceWidth(piece.width,
                [&](auto width) { Kernels::stencilRows<width()>(table, which, piece.in, piece.out, begin, end); });
}

#define HONEYCOMB_INSTANTIATE(Real)                                                                                  \
  template void circulantFaces(const Far::LevelTable&, const Far::CirculantBatch&, const Piece<Real>&, std::int64_t, \
                               std::int64_t);                                                                        \
  template void denseRows(const Far::LevelTable&, const Far::DenseRows&, const Piece<Real>&, std::int64_t,           \
                          std::int64_t);                                                                             \
  template void projectedFaces(const Far::LevelTable&, const Piece<Real>&, std::int64_t, std::int64_t);              \
  template void looseRows(const Far::LevelTable&, const Piece<Real>&, std::int64_t, std::int64_t);                   \
  template void faceSums(const Far::LevelTable&, const Piece<Real>&, std::span<Real>, std::int64_t, std::int64_t);   \
  template void summedRows(const Far::LevelTable&, const Piece<Real>&, std::span<const Real>, std::int64_t,          \
                           std::int64_t);                                                                            \
  template void stencilRows(const Far::StencilTable&, Far::StencilWeights, const Piece<Real>&, std::int64_t,         \
                            std::int64_t);
HONEYCOMB_INSTANTIATE(float)
HONEYCOMB_INSTANTIATE(double)
#undef HONEYCOMB_INSTANTIATE

}  // namespace honeycomb::Osd::Plain
