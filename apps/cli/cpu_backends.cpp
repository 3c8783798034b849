#include "apps/cli/frame_tiles.h"
#include "apps/cli/surface_evaluator.h"
#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/tables/tile_table.h"
#include "osd/cpu_evaluator.h"
#include "osd/normal_evaluator.h"
#include "osd/tile_evaluator.h"
#include "osd/tile_size.h"

namespace honeycomb::Cli {
namespace {

using Threads = Osd::CpuEvaluator::Threads;
using Instructions = Osd::CpuEvaluator::Instructions;

/// Three numbers a point.
constexpr Osd::BufferDescriptor kPacked{};

/// Single and double precision by one Own::evaluateAs<Real>.
template <class Own>
class EitherPrecision : public SurfaceEvaluator {
 public:
  Result<void> evaluate(std::span<const float> control, Surface<float>& surface) override {
    return static_cast<Own&>(*this).template evaluateAs<float>(control, surface);
  }
  Result<void> evaluate(std::span<const double> control, Surface<double>& surface) override {
    return static_cast<Own&>(*this).template evaluateAs<double>(control, surface);
  }
};

class CpuSurfaceEvaluator : public EitherPrecision<CpuSurfaceEvaluator> {
 public:
  CpuSurfaceEvaluator(const SurfaceTables& tables, Normals normals, Osd::CpuEvaluator evaluator)
      : levels_(tables.levels), vertexCount_(tables.vertexCount), normals_(normals), evaluator_(std::move(evaluator)) {}

  template <class Real>
  Result<void> evaluateAs(std::span<const Real> control, Surface<Real>& surface) {
    surface.vertexCount = vertexCount_;
    surface.points.resize(3 * at(levels_.pointCount(levels_.levelCount())));
    const Osd::PointsOut<Real> points{surface.points, kPacked};
    Result<void> refined =
        evaluator_.evaluate<Real>(levels_, levels_.levelCount(), Osd::Points<Real>{control, kPacked}, points);
    if (!refined || normals_ == Normals::none) return refined;
    surface.normals.resize(3 * at(surface.vertexCount));
    return evaluator_.vertexLimits<Real>(levels_.limits(), Osd::Points<Real>{surface.points, kPacked},
                                         Osd::PointsOut<Real>{{}, kPacked},
                                         Osd::PointsOut<Real>{surface.normals, kPacked});
  }

 private:
  Far::LevelTables levels_;
  std::int32_t vertexCount_;
  Normals normals_;
  Osd::CpuEvaluator evaluator_;
};

/// Level after level, with fast normals.
class FastNormalEvaluator : public EitherPrecision<FastNormalEvaluator> {
 public:
  FastNormalEvaluator(const Far::Refinement& refinement, Far::NormalTable table, Threads threads)
      : refinement_(refinement), table_(std::move(table)), evaluator_(threads) {}

  template <class Real>
  Result<void> evaluateAs(std::span<const Real> control, Surface<Real>& surface) {
    surface.vertexCount = refinement_.last().topology.vertexCount();
    surface.points.resize(3 * at(refinement_.last().pointCount()));
    surface.normals.resize(surface.points.size());
    Result<void> done = evaluator_.evaluate<Real>(refinement_, table_, Osd::Points<Real>{control, kPacked},
                                                  Osd::PointsOut<Real>{surface.points, kPacked},
                                                  Osd::PointsOut<Real>{surface.normals, kPacked});
    surface.normals.resize(3 * at(surface.vertexCount));  // points that are no vertices have none
    return done;
  }

 private:
  const Far::Refinement& refinement_;
  Far::NormalTable table_;
  Osd::NormalEvaluator evaluator_;
};

/// A frame after another by tiles, which are built once and shared.
class TileSurfaceEvaluator : public EitherPrecision<TileSurfaceEvaluator> {
 public:
  TileSurfaceEvaluator(const SurfaceTables& tables, std::shared_ptr<const Far::TileTable> tiles,
                       Osd::CpuEvaluator::Threads threads)
      : levels_(tables.levels),
        vertexCount_(tables.vertexCount),
        tiles_(std::move(tiles)),
        evaluator_({.threads = threads}) {}

  template <class Real>
  Result<void> evaluateAs(std::span<const Real> control, Surface<Real>& surface) {
    surface.vertexCount = vertexCount_;
    surface.points.resize(3 * at(levels_.pointCount(levels_.levelCount())));
    return evaluator_.evaluate<Real>(levels_, *tiles_, tiles_->lastLevel, Osd::Points<Real>{control, kPacked},
                                     Osd::PointsOut<Real>{surface.points, kPacked});
  }

 private:
  Far::LevelTables levels_;
  std::int32_t vertexCount_;
  std::shared_ptr<const Far::TileTable> tiles_;
  Osd::TileEvaluator evaluator_;
};

class CpuBackend : public Backend {
 public:
  CpuBackend(std::string_view name, Osd::CpuEvaluator::Threads threads, Osd::CpuEvaluator::Instructions instructions)
      : name_(name), threads_(threads), instructions_(instructions) {}

  std::string_view name() const override { return name_; }
  Result<std::unique_ptr<SurfaceEvaluator>> evaluator(const Far::Refinement& refinement, Normals normals) override {
    if (normals == Normals::fast) {
      Result<Far::NormalTable> table = Far::buildNormalTable(refinement, refinement.levelCount());
      if (!table) return tl::unexpected(table.error());
      return std::make_unique<FastNormalEvaluator>(refinement, std::move(*table), threads_);
    }
    return std::make_unique<CpuSurfaceEvaluator>(refinement, normals, Osd::CpuEvaluator(threads_, instructions_));
  }
  int framesAtOnce() const override { return threads_ == Threads::all ? Parallel::threadCount() : 1; }
  // A frame a task: threads that work on frames of their own wait for nobody.
  Result<FrameEvaluators> frameEvaluators(const SurfaceTables& tables, std::int32_t frames, int atOnce) override {
    const Threads threads = atOnce == 1 ? threads_ : Threads::one;
    const auto tiles = tilesFor(tables, frames, atOnce);
    if (!tiles) return tl::unexpected(tiles.error());
    FrameEvaluators evaluators;
    if (*tiles != nullptr) evaluators.tileBytes = (*tiles)->byteCount();
    for (int i = 0; i < atOnce; ++i) {
      if (*tiles != nullptr) {
        evaluators.each.push_back(std::make_unique<TileSurfaceEvaluator>(tables, *tiles, threads));
      } else {
        evaluators.each.push_back(
            std::make_unique<CpuSurfaceEvaluator>(tables, Normals::none, Osd::CpuEvaluator(threads, instructions_)));
      }
    }
    return evaluators;
  }

 private:
  /// Those that are there, or built where they pay; null: none.
  Result<std::shared_ptr<const Far::TileTable>> tilesFor(const SurfaceTables& tables, std::int32_t frames,
                                                         int atOnce) const {
    if (instructions_ != Instructions::vectors) return nullptr;
    if (tables.tiles != nullptr) return std::shared_ptr<const Far::TileTable>(std::shared_ptr<void>(), tables.tiles);
    if (tables.refinement == nullptr || !tilesPay(tables.levels, frames, atOnce)) return nullptr;
    Result<Far::TileTable> built = Far::buildTileTable(*tables.refinement, Osd::cpuTileOptions());
    if (!built) return tl::unexpected(built.error());
    return std::make_shared<const Far::TileTable>(std::move(*built));
  }

  std::string_view name_;
  Threads threads_;
  Instructions instructions_;
};

}  // namespace

Result<std::unique_ptr<Backend>> openSerial() {
  return std::make_unique<CpuBackend>("serial", Threads::one, Instructions::plain);
}

Result<std::unique_ptr<Backend>> openSimd() {
  return std::make_unique<CpuBackend>("simd", Threads::one, Instructions::vectors);
}

Result<std::unique_ptr<Backend>> openTbb() {
  return std::make_unique<CpuBackend>("tbb", Threads::all, Instructions::vectors);
}

}  // namespace honeycomb::Cli
