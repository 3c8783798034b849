#include "far/tables/patch_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/topology/three_valent.h"

namespace honeycomb::Far {
namespace {

using Point = PatchValue<3>;

template <class Real>
Result<void> checkPoints(std::span<const Real> points, std::int32_t stride, std::int32_t vertexCount) {
  if (stride < 3)
    return fail(ErrorCode::invalidOption,
                fmt::format("the points' stride is {}; it must be at least 3, for x y z", stride));
  const std::int64_t needed = vertexCount == 0 ? 0 : std::int64_t{vertexCount - 1} * stride + 3;
  if (static_cast<std::int64_t>(points.size()) >= needed) return {};
  return fail(ErrorCode::invalidOption,
              fmt::format("{} numbers are too few for {} control points with stride {}; give at least {}",
                          points.size(), vertexCount, stride, needed));
}

template <class Real>
PatchFaces<Point> gatherPoints(const VertexPatch& patch, std::span<const Real> points, std::int32_t stride) {
  return patch.gather<Point>([&](std::int32_t v) {
    const auto p = points.subspan(at(v) * at(stride), 3);
    return Point{{static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])}};
  });
}

std::array<double, 3> unitNormal(const Point& du, const Point& dv) {
  const std::array<double, 3> n{du[1] * dv[2] - du[2] * dv[1], du[2] * dv[0] - du[0] * dv[2],
                                du[0] * dv[1] - du[1] * dv[0]};
  const double length = std::hypot(n[0], n[1], n[2]);
  if (!(length >= std::numeric_limits<double>::min()) || !std::isfinite(length)) return {};
  return {n[0] / length, n[1] / length, n[2] / length};
}

}  // namespace

PatchTable::PatchTable(Topology topology, std::vector<std::int32_t> vertices, std::vector<std::int32_t> patches)
    : topology_(std::move(topology)), vertices_(std::move(vertices)), patches_(std::move(patches)) {
  std::vector<std::uint8_t> hexagons(vertices_.size());
  Parallel::forEach(0, patchCount(),
                    [&](std::int64_t p) { hexagons[at(p)] = regular(static_cast<std::int32_t>(p)) ? 1 : 0; });
  for (std::int32_t p = 0; p < patchCount(); ++p) {
    if (hexagons[at(p)] != 0) regular_.push_back(p);
  }
}

Result<PatchTable> PatchTable::build(Topology topology) {
  if (Result<void> sound = checkThreeValent(topology); !sound) return tl::unexpected(sound.error());
  std::vector<std::int32_t> patches(at(topology.vertexCount()));
  Parallel::forEach(0, topology.vertexCount(), [&](std::int64_t v) {
    patches[at(v)] = topology.onBoundary(static_cast<std::int32_t>(v)) ? 0 : 1;
  });
  const std::vector<std::int32_t> isInside = patches;
  std::vector<std::int32_t> vertices(at(Parallel::exclusiveScan(patches)));
  Parallel::forEach(0, topology.vertexCount(), [&](std::int64_t v) {
    if (isInside[at(v)] != 0) {
      vertices[at(patches[at(v)])] = static_cast<std::int32_t>(v);
    } else {
      patches[at(v)] = -1;
    }
  });
  return PatchTable(std::move(topology), std::move(vertices), std::move(patches));
}

std::array<std::int32_t, 3> PatchTable::neighbours(std::int32_t patch) const {
  const std::array<std::int32_t, 3> h = this->patch(patch).halfEdges();
  return {patchOf(topology_.dest(h[1])), patchOf(topology_.dest(h[2])), patchOf(topology_.dest(h[0]))};
}

Result<void> PatchTable::check(const PatchSample& sample) const {
  if (sample.patch < 0 || sample.patch >= patchCount())
    return fail(
        ErrorCode::invalidOption,
        fmt::format("there is no patch {}: the surface has {} patches, counted from 0", sample.patch, patchCount()));
  const Barycentric& u = sample.barycentric;
  // Written so that a coordinate that is not a number fails.
  const bool positive = std::all_of(u.begin(), u.end(), [](double x) { return x >= -kBarycentricTolerance; });
  if (positive && std::abs(u[0] + u[1] + u[2] - 1) <= kBarycentricTolerance) return {};
  return fail(
      ErrorCode::invalidOption,
      fmt::format("({}, {}, {}) is outside the triangle of patch {}; barycentric coordinates are at least 0 and "
                  "sum to 1",
                  u[0], u[1], u[2], sample.patch));
}

template <class Real>
Result<std::vector<double>> PatchTable::bezierPoints(std::span<const Real> points, std::int32_t stride) const {
  if (Result<void> sound = checkPoints(points, stride, topology_.vertexCount()); !sound) {
    return tl::unexpected(sound.error());
  }
  std::vector<double> result(30 * regular_.size());
  const auto evaluatePatchPoints = [&](std::int64_t r) {
    const std::array<Point, 10> bezier = Far::bezierPoints(gatherPoints(patch(regular_[at(r)]), points, stride));
    for (std::size_t i = 0; i < 10; ++i) {
      std::copy(bezier[i].numbers.begin(), bezier[i].numbers.end(),
                result.begin() + static_cast<std::ptrdiff_t>(30 * at(r) + 3 * i));
    }
  };
  Parallel::forEach(0, static_cast<std::int64_t>(regular_.size()), evaluatePatchPoints);
  return result;
}

template <class Real>
Result<PatchPoint> PatchTable::evaluate(std::int32_t patch, const Barycentric& barycentric,
                                        std::span<const Real> points, std::int32_t stride) const {
  if (Result<void> sound = check({patch, barycentric}); !sound) return tl::unexpected(sound.error());
  if (Result<void> sound = checkPoints(points, stride, topology_.vertexCount()); !sound) {
    return tl::unexpected(sound.error());
  }
  const PatchDerivatives<Point> at = evaluatePatch(gatherPoints(this->patch(patch), points, stride), barycentric);
  return PatchPoint{at.position.numbers,      at.du.numbers,         at.dv.numbers,
                    at.duu.numbers,           at.duv.numbers,        at.dvv.numbers,
                    unitNormal(at.du, at.dv), at.extraordinaryCorner};
}

template Result<std::vector<double>> PatchTable::bezierPoints(std::span<const float>, std::int32_t) const;
template Result<std::vector<double>> PatchTable::bezierPoints(std::span<const double>, std::int32_t) const;
template Result<PatchPoint> PatchTable::evaluate(std::int32_t, const Barycentric&, std::span<const float>,
                                                 std::int32_t) const;
template Result<PatchPoint> PatchTable::evaluate(std::int32_t, const Barycentric&, std::span<const double>,
                                                 std::int32_t) const;

}  // namespace honeycomb::Far
