#include "osd/tile_evaluator.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "osd/cpu_pieces.h"
#include "osd/simd/tiles.h"
#include "osd/tile_checks.h"
#include "osd/tile_kernels.h"

namespace honeycomb::Osd {

namespace {

constexpr std::size_t kLine = 64 / sizeof(float);

/// The first number from p on that begins a cache line.
template <class Real>
Real* onLine(Real* p) {
  const std::size_t behind = reinterpret_cast<std::uintptr_t>(p) % 64;
  return behind == 0 ? p : p + (64 - behind) / sizeof(Real);
}

}  // namespace

/// A thread's working memory: what is gathered for the target, the tile's points, its face normals.
template <class Real>
struct TileEvaluator::Scratch {
  Real* stream;
  Real* points;
  Real* normals;

  static std::size_t size(const Far::TileTable& tiles, bool normals) {
    const std::int32_t own = tiles.largestTile + (normals ? tiles.normals.largestTile : 0);
    return kLine + at(Kernels::kStreamRoom) + at(own) * at(Kernels::kTileStride);
  }
  Scratch(std::vector<Real>& numbers, const Far::TileTable& tiles)
      : stream(onLine(numbers.data())),
        points(stream + Kernels::kStreamRoom),
        normals(points + at(tiles.largestTile) * at(Kernels::kTileStride)) {}
};

template <>
TileEvaluator::Memory<float>& TileEvaluator::memory<float>() {
  return single_;
}
template <>
TileEvaluator::Memory<double>& TileEvaluator::memory<double>() {
  return double_;
}

template <class Real>
Result<void> TileEvaluator::check(const Far::TileTable& tiles, std::int32_t level, const Points<Real>& control,
                                  const PointsOut<Real>& refined, const TileRequest<Real>& request) const {
  if (auto ok = checkTileLevel(tiles, level); !ok) return ok;
  if (auto ok = checkTileChoice(tiles, request.only); !ok) return ok;
  const std::int32_t count = tiles.pointCount[at(level)];
  if (auto ok = checkPoints(control, tiles.pointCount.front(), refined, count); !ok) return ok;
  if (request.normals.data.empty()) return {};
  if (tiles.normalKind == Far::TileNormalKind::none) {
    return fail(ErrorCode::invalidOption, "the tiles were built without normals; ask for them in TileOptions");
  }
  if (level != tiles.lastLevel) {
    return fail(ErrorCode::invalidOption,
                fmt::format("normals are of level {} alone; level {} was asked for", tiles.lastLevel, level));
  }
  return checkNormals(control, request.normals, count);
}

template <class Real>
Result<void> TileEvaluator::evaluate(Far::LevelTables levels, const Far::TileTable& tiles, std::int32_t level,
                                     const Points<Real>& control, const PointsOut<Real>& refined,
                                     const TileRequest<Real>& request) {
  if (auto ok = check(tiles, level, control, refined, request); !ok) return ok;
  if (level <= tiles.rootLevel) return chained_.evaluate(levels, level, control, refined);
  Memory<Real>& memory = this->memory<Real>();
  if (auto done = memory.shared.evaluate(chained_, levels, tiles, level, control, refined, request.normals); !done) {
    return done;
  }
  const std::int64_t count = request.only ? std::ssize(*request.only) : std::ssize(tiles.tiles);
  const bool alone = options_.threads == CpuEvaluator::Threads::one;
  const int workers = alone ? 1 : Parallel::threadCount();
  memory.reserve(workers, Scratch<Real>::size(tiles, !request.normals.data.empty()));
  const auto run = [&](int worker, std::int64_t t) {
    const auto tile = request.only ? (*request.only)[at(t)] : static_cast<std::int32_t>(t);
    evaluateTile(tiles, tile, level, refined, request.normals, memory.shared, {memory.scratch[at(worker)], tiles});
  };
  // By reference: a std::function of the loop itself would allocate in every frame.
  Parallel::forItems(count, workers, std::cref(run));
  return {};
}

template <class Real>
void TileEvaluator::evaluateTile(const Far::TileTable& tiles, std::int32_t number, std::int32_t level,
                                 const PointsOut<Real>& refined, const PointsOut<Real>& normals,
                                 const TileShared<Real>& shared, const Scratch<Real>& scratch) const {
  const auto bytesOf = [&](const PointsOut<Real>& target) {
    return target.data.empty() ? 0 : target.desc.extent(tiles.pointCount[at(level)]) * std::int64_t{sizeof(Real)};
  };
  const bool tooMuch = bytesOf(refined) + bytesOf(normals) >= options_.cachedBytes;
  const auto streamOf = [&](const PointsOut<Real>& target) {
    return tooMuch || bytesOf(target) >= options_.streamedBytes ? scratch.stream : nullptr;
  };
  const Points<Real>& root = shared.root();
  const Far::Tile& tile = tiles.tiles[at(number)];
  const bool fast = !normals.data.empty() && tiles.normalKind == Far::TileNormalKind::fast;
  const bool behind = !normals.data.empty() && tiles.normalKind == Far::TileNormalKind::exact;
  const std::int32_t last = behind ? level + 1 : level;
  // Into caches that don't have them yet points go faster beside the longer work of their normals: 14 % less time.
  std::span<const Far::TileRings> later;
  if (behind && root.desc.length == 3 && refined.desc.stride == 3 && normals.desc.stride == 3 &&
      streamOf(refined) == nullptr) {
    const Far::TileLimits::Range& rings = tiles.limits.ringTiles[at(number)];
    later = std::span(tiles.limits.rings).subspan(at(rings.first), at(rings.count));
  }
  const bool vectors = options_.instructions == CpuEvaluator::Instructions::vectors;
  for (std::int32_t done = 0; done < root.desc.length; done += kPiece) {
    View<const Real> in = viewOf(root);
    View<Real> out = viewOf(refined);
    in.data += done;
    out.data += done;
    const View<const Real> sharedPoints{shared.points().data() + done, root.desc.length};
    Real* const crosses = fast && done == 0 ? scratch.normals : nullptr;
    const Kernels::TileViews<Real> views{in,   sharedPoints,      out,     scratch.points, level,
                                         last, streamOf(refined), crosses, later};
    forPieceWidth(std::min(kPiece, root.desc.length - done), [&](auto width) {
      if constexpr (std::is_same_v<Real, float>) {
        if (vectors) return Simd::evaluateTile(tiles, tile, views, width());
      }
      Kernels::evaluateTile<width()>(tiles, tile, views);
    });
  }
  if (normals.data.empty()) return;
  const Kernels::NormalViews<Real> views{{shared.normals().data(), 3},
                                         viewOf(normals),
                                         scratch.normals,
                                         streamOf(normals),
                                         later.empty() ? View<Real>{} : viewOf(refined)};
  if constexpr (std::is_same_v<Real, float>) {
    if (vectors) return Simd::evaluateTileNormals(tiles, number, scratch.points, views);
  }
  Kernels::evaluateTileNormals(tiles, number, scratch.points, views);
}

#define HONEYCOMB_INSTANTIATE(Real)                                                                    \
  template Result<void> TileEvaluator::evaluate(Far::LevelTables, const Far::TileTable&, std::int32_t, \
                                                const Points<Real>&, const PointsOut<Real>&,           \
                                                const TileRequest<Real>&);
HONEYCOMB_INSTANTIATE(float)
HONEYCOMB_INSTANTIATE(double)
#undef HONEYCOMB_INSTANTIATE

}  // namespace honeycomb::Osd
