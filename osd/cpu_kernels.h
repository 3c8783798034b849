#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "far/base/index.h"
#include "far/tables/level_table.h"
#include "far/tables/limit_table.h"
#include "far/tables/stencil_table.h"
#include "osd/piece.h"

/// The arithmetic of every batch kind, once, for the CPU. The order of operations is that written down with the
/// batches; shaders/*.comp do the same under the same names.
namespace honeycomb::Osd::Kernels {

template <int Width, class Real>
std::array<std::remove_const_t<Real>, at(Width)> load(Real* p) {
  std::array<std::remove_const_t<Real>, at(Width)> v;
  for (int c = 0; c < Width; ++c) v[at(c)] = p[c];
  return v;
}

template <class Real, std::size_t Width>
void store(const std::array<Real, Width>& v, Real* p) {
  for (std::size_t c = 0; c < Width; ++c) p[c] = v[c];
}

template <class Real, std::size_t Width>
std::array<Real, Width> operator+(const std::array<Real, Width>& a, const std::array<Real, Width>& b) {
  std::array<Real, Width> r;
  for (std::size_t c = 0; c < Width; ++c) r[c] = a[c] + b[c];
  return r;
}

template <class Real, std::size_t Width>
std::array<Real, Width> operator-(const std::array<Real, Width>& a, const std::array<Real, Width>& b) {
  std::array<Real, Width> r;
  for (std::size_t c = 0; c < Width; ++c) r[c] = a[c] - b[c];
  return r;
}

template <class Real, std::size_t Width>
std::array<Real, Width> operator-(const std::array<Real, Width>& a) {
  std::array<Real, Width> r;
  for (std::size_t c = 0; c < Width; ++c) r[c] = -a[c];
  return r;
}

template <class Real, std::size_t Width>
std::array<Real, Width> operator*(Real w, const std::array<Real, Width>& a) {
  std::array<Real, Width> r;
  for (std::size_t c = 0; c < Width; ++c) r[c] = w * a[c];
  return r;
}

/// Out of `sides` corners p, the N outputs of CirculantForm::direct. N is `sides` where it is known to the compiler,
/// else 0.
template <int N, class Real, std::size_t Width>
void circulantDirect(const Real* c, const std::array<Real, Width>* p, std::int32_t sides, const View<Real>& out,
                     std::int32_t first) {
  const std::int32_t n = N > 0 ? N : sides;
  for (std::int32_t i = 0; i < n; ++i) {
    std::array<Real, Width> sum = c[0] * p[i];
    for (std::int32_t k = 1; k < n; ++k) sum = sum + c[k] * p[i + k < n ? i + k : i + k - n];
    store(sum, out.point(first + i));
  }
}

template <int N, class Real, std::size_t Width>
void circulantEvenOdd(const Real* form, const std::array<Real, Width>* p, std::int32_t sides, const View<Real>& out,
                      std::int32_t first) {
  const std::int32_t m = (N > 0 ? N : sides) / 2;
  // Twice over, the second time with the sign of a wrapped term, so that no index wraps.
  std::array<Real, Width> q[N > 0 ? N : Far::kLargestCirculant];
  std::array<Real, Width> d[N > 0 ? N : Far::kLargestCirculant];
  for (std::int32_t j = 0; j < m; ++j) {
    q[j] = q[j + m] = p[j] + p[j + m];
    d[j] = p[j] - p[j + m];
    d[j + m] = -d[j];
  }
  for (std::int32_t i = 0; i < m; ++i) {
    std::array<Real, Width> even = form[0] * q[i];
    std::array<Real, Width> odd = form[m] * d[i];
    for (std::int32_t k = 1; k < m; ++k) {
      even = even + form[k] * q[i + k];
      odd = odd + form[m + k] * d[i + k];
    }
    store(even + odd, out.point(first + i));
    store(even - odd, out.point(first + i + m));
  }
}

template <class Real, std::size_t Width>
void circulantQuad(const Real* form, const std::array<Real, Width>* p, const View<Real>& out, std::int32_t first) {
  const std::array<Real, Width> d[] = {p[0] - p[2], p[1] - p[3]};
  const auto s = form[0] * ((p[0] + p[2]) + (p[1] + p[3]));
  const std::array<Real, Width> o[] = {form[1] * (d[0] + d[1]), form[1] * (d[1] - d[0])};
  for (std::int32_t i = 0; i < 2; ++i) {
    store(s + o[i], out.point(first + i));
    store(s - o[i], out.point(first + i + 2));
  }
}

template <class Real, std::size_t Width>
void circulantHexagon(const Real* form, const std::array<Real, Width>* p, const View<Real>& out, std::int32_t first) {
  const std::array<Real, Width> q[] = {p[0] + p[3], p[1] + p[4], p[2] + p[5]};
  const std::array<Real, Width> d[] = {p[0] - p[3], p[1] - p[4], p[2] - p[5]};
  const auto s = form[0] * ((q[0] + q[1]) + q[2]);
  const std::array<Real, Width> o[] = {form[2] * (d[0] + d[1]), form[2] * (d[1] + d[2]), form[2] * (d[2] - d[0])};
  for (std::int32_t i = 0; i < 3; ++i) {
    const auto e = s - form[1] * q[(i + 2) % 3];
    store(e + o[i], out.point(first + i));
    store(e - o[i], out.point(first + i + 3));
  }
}

template <int N, class Real, std::size_t Width>
void circulantFace(Far::CirculantForm which, const Real* form, const std::array<Real, Width>* p, std::int32_t sides,
                   const View<Real>& out, std::int32_t first) {
  switch (which) {
    case Far::CirculantForm::direct:
      return circulantDirect<N>(form, p, sides, out, first);
    case Far::CirculantForm::evenOdd:
      return circulantEvenOdd<N>(form, p, sides, out, first);
    case Far::CirculantForm::quad:
      if constexpr (N == 4) circulantQuad(form, p, out, first);
      return;
    case Far::CirculantForm::hexagon:
      if constexpr (N == 6) circulantHexagon(form, p, out, first);
      return;
  }
}

/// Faces begin .. end-1 of a batch.
template <int N, int Width, class Real>
void circulantFaces(const Far::LevelTable& table, const Far::CirculantBatch& batch, const View<const Real>& in,
                    const View<Real>& out, std::int64_t begin, std::int64_t end) {
  const std::int32_t n = N > 0 ? N : batch.sides;
  const Real* form = table.weightsAs<Real>().data() + batch.firstForm;
  const std::int32_t* index = table.indices.data() + batch.firstIndex + begin * n;
  std::array<Real, at(Width)> p[N > 0 ? N : Far::kLargestCirculant];
  for (std::int64_t g = begin; g < end; ++g, index += n) {
    for (std::int32_t i = 0; i < n; ++i) p[i] = load<Width>(in.point(index[i]));
    const auto first = static_cast<std::int32_t>(batch.firstOutput + g * n);
    circulantFace<N>(batch.form, form, p, n, out, first);
  }
}

/// sum_j weights[j] p_j over `count` points, in blocks: see ProjectedFace.
template <int Width, class Real, class Index>
std::array<Real, at(Width)> blockedSum(const Real* weights, const Index* index, std::int32_t count,
                                       const View<const Real>& in) {
  std::array<Real, at(Width)> total{};
  for (std::int32_t block = 0; block < count; block += Far::kProjectionBlock) {
    const std::int32_t end = std::min(count, block + Far::kProjectionBlock);
    std::array<Real, at(Width)> sum = weights[block] * load<Width>(in.point(index[block]));
    for (std::int32_t j = block + 1; j < end; ++j) sum = sum + weights[j] * load<Width>(in.point(index[j]));
    total = block == 0 ? sum : total + sum;
  }
  return total;
}

template <int Width, class Real>
void projectedFace(const Far::LevelTable& table, const Far::ProjectedFace& face, const View<const Real>& in,
                   const View<Real>& out) {
  const Real* w = table.weightsAs<Real>().data() + face.firstWeight;
  const std::int32_t* index = table.indices.data() + face.firstIndex;
  const Real* s = w + 2;
  const auto sum = blockedSum<Width>(s, index, face.corners, in);
  const auto cosine = blockedSum<Width>(s + face.corners, index, face.corners, in);
  const auto sine = blockedSum<Width>(s + 2 * std::int64_t{face.corners}, index, face.corners, in);
  const Real* x = s + 3 * std::int64_t{face.corners};
  const Real* y = x + face.outputs;
  const Real* z = y + face.outputs;
  for (std::int32_t i = 0; i < face.outputs; ++i) {
    const std::int32_t turned = face.firstCorner + i;
    const std::int32_t a = turned < face.corners ? turned : turned - face.corners;
    const std::int32_t b = a + 1 == face.corners ? 0 : a + 1;
    const auto here = w[0] * load<Width>(in.point(index[a])) + w[1] * load<Width>(in.point(index[b]));
    store(((here + x[i] * sum) + y[i] * cosine) + z[i] * sine, out.point(face.firstOutput + i));
  }
}

/// Rows begin .. end-1 of a batch. N is its width where that is known to the compiler, else 0.
template <int N, int Width, class Real>
void denseRows(const Far::LevelTable& table, const Far::DenseRows& batch, const View<const Real>& in,
               const View<Real>& out, std::int64_t begin, std::int64_t end) {
  const std::int32_t n = N > 0 ? N : batch.width;
  const Real* w = table.weightsAs<Real>().data() + batch.firstWeight;
  const std::int32_t* index = table.indices.data() + batch.firstIndex + begin * n;
  for (std::int64_t g = begin; g < end; ++g, index += n) {
    auto sum = w[0] * load<Width>(in.point(index[0]));
    for (std::int32_t j = 1; j < n; ++j) sum = sum + w[j] * load<Width>(in.point(index[j]));
    store(sum, out.point(static_cast<std::int32_t>(batch.firstOutput + g)));
  }
}

/// (weights[first] p_first + weights[first+1] p_first+1) + ... up to, without, `last`: one row of compressed rows.
template <int Width, class Real, class Index>
std::array<Real, at(Width)> rowSum(const Real* weights, const Index* index, std::int32_t first, std::int32_t last,
                                   const View<const Real>& in) {
  auto sum = weights[first] * load<Width>(in.point(index[first]));
  for (std::int32_t b = first + 1; b < last; ++b) sum = sum + weights[b] * load<Width>(in.point(index[b]));
  return sum;
}

/// Rows begin .. end-1.
template <int Width, class Real>
void looseRows(const Far::LevelTable& table, const View<const Real>& in, const View<Real>& out, std::int64_t begin,
               std::int64_t end) {
  const Far::LooseRows& rows = table.loose;
  const Real* weights = table.weightsAs<Real>().data() + rows.firstWeight;
  const std::int32_t* index = table.indices.data() + rows.firstIndex;
  for (std::int64_t r = begin; r < end; ++r) {
    store(rowSum<Width>(weights, index, rows.offsets[at(r)], rows.offsets[at(r) + 1], in),
          out.point(rows.outputs[at(r)]));
  }
}

/// S of each large face begin .. end-1: `width` numbers a face.
template <int Width, class Real>
void faceSums(const Far::LevelTable& table, const View<const Real>& in, const View<Real>& sums, std::int64_t begin,
              std::int64_t end) {
  for (std::int64_t f = begin; f < end; ++f) {
    const Far::ProjectedFace& face = table.projected[at(f)];
    const Real* s = table.weightsAs<Real>().data() + face.firstWeight + 2;
    store(blockedSum<Width>(s, table.indices.data() + face.firstIndex, face.corners, in),
          sums.point(static_cast<std::int32_t>(f)));
  }
}

/// Rows begin .. end-1, which read the sums of the table's large faces.
template <int Width, class Real>
void summedRows(const Far::LevelTable& table, const View<const Real>& in, const View<const Real>& sums,
                const View<Real>& out, std::int64_t begin, std::int64_t end) {
  const Far::SummedRows& summed = table.summed;
  const Far::LooseRows& rows = summed.rows;
  const Real* weights = table.weightsAs<Real>().data() + rows.firstWeight;
  const Real* shares = table.weightsAs<Real>().data() + summed.firstShare;
  const std::int32_t* index = table.indices.data() + rows.firstIndex;
  for (std::int64_t r = begin; r < end; ++r) {
    const std::int32_t first = rows.offsets[at(r)];
    const std::int32_t last = rows.offsets[at(r) + 1];
    std::int32_t t = summed.shareOffsets[at(r)];
    const auto share = [&](std::int32_t i) { return shares[i] * load<Width>(sums.point(summed.faces[at(i)])); };
    auto sum = first < last ? rowSum<Width>(weights, index, first, last, in) : share(t++);
    for (; t < summed.shareOffsets[at(r) + 1]; ++t) sum = sum + share(t);
    store(sum, out.point(rows.outputs[at(r)]));
  }
}

/// Rows begin .. end-1, row r to point r.
template <int Width, class Real>
void stencilRows(const Far::StencilTable& table, Far::StencilWeights which, const View<const Real>& in,
                 const View<Real>& out, std::int64_t begin, std::int64_t end) {
  const Real* weights = table.weightsAs<Real>(which).data();
  for (std::int64_t r = begin; r < end; ++r) {
    store(rowSum<Width>(weights, table.indices.data(), table.offsets[at(r)], table.offsets[at(r) + 1], in),
          out.point(static_cast<std::int32_t>(r)));
  }
}

/// A vector made unit, the zero vector where that has no meaning: see LimitRows.
template <class Real>
std::array<Real, 3> unit(const std::array<Real, 3>& n) {
  const Real q = (n[0] * n[0] + n[1] * n[1]) + n[2] * n[2];
  if (!(q >= std::numeric_limits<Real>::min()) || !std::isfinite(q)) return {};
  const Real r = Real{1} / std::sqrt(q);
  return {n[0] * r, n[1] * r, n[2] * r};
}

/// a x b made unit: see LimitRows.
template <class Real>
std::array<Real, 3> unitNormal(const std::array<Real, 3>& a, const std::array<Real, 3>& b) {
  return unit<Real>({(a[1] * b[2] - a[2] * b[1]) + Real{0}, (a[2] * b[0] - a[0] * b[2]) + Real{0},
                     (a[0] * b[1] - a[1] * b[0]) + Real{0}});
}

/// ((n_a + n_b) + n_c) + .. made unit: see NormalTable.
template <class Real, class Index>
std::array<Real, 3> normalSum(const Index* faces, std::int32_t count, const View<const Real>& normals) {
  if (count == 0) return {};
  std::array<Real, 3> sum = load<3>(normals.point(faces[0]));
  for (std::int32_t i = 1; i < count; ++i) sum = sum + load<3>(normals.point(faces[i]));
  return unit(sum);
}

/// Elements begin .. end-1 of a batch; a view without data is not written.
template <class Real>
void frames(const Far::LimitRows& rows, const Far::FrameBatch& batch, const View<const Real>& in,
            const View<Real>& positions, const View<Real>& normals, std::int64_t begin, std::int64_t end) {
  const std::int32_t n = batch.sides;
  const Real* w = rows.weightsAs<Real>().data() + batch.firstWeight;
  for (std::int64_t g = begin; g < end; ++g) {
    const std::int32_t* index = rows.indices.data() + batch.firstIndex + g * n;
    const std::int32_t element = rows.elements[at(batch.firstElement + g)];
    if (positions.data != nullptr) store(blockedSum<3>(w, index, n, in), positions.point(element));
    if (normals.data == nullptr) continue;
    const auto t1 = blockedSum<3>(w + n, index, n, in);
    const auto t2 = blockedSum<3>(w + 2 * std::int64_t{n}, index, n, in);
    store(unitNormal(t1, t2), normals.point(element));
  }
}

}  // namespace honeycomb::Osd::Kernels
