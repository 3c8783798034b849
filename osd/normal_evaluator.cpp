#include "osd/normal_evaluator.h"

#include <fmt/format.h>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "osd/cpu_kernels.h"
#include "osd/cpu_pieces.h"

namespace honeycomb::Osd {

namespace {

/// Faces or vertices a task takes: about ten microseconds.
constexpr std::int64_t kGrain = 512;

template <class Body>
void split(CpuEvaluator::Threads threads, std::int64_t count, const Body& body) {
  if (threads == CpuEvaluator::Threads::one) {
    body(std::int64_t{0}, count);
  } else {
    Parallel::forRange(0, count, kGrain, body);
  }
}

}  // namespace

template <class Real>
Result<void> NormalEvaluator::evaluate(Far::LevelTables levels, const Far::NormalTable& table,
                                       const Points<Real>& control, const PointsOut<Real>& refined,
                                       const PointsOut<Real>& normals) {
  const std::int32_t last = table.level;
  if (auto ok = checkPoints(control, levels.pointCount(0), refined, levels.pointCount(last)); !ok) {
    return ok;
  }
  if (auto ok = checkNormals(control, normals, std::ssize(table.offsets) - 1); !ok) return ok;
  std::vector<Real> faceNormals(3 * at(table.faceNormals));
  const View<Real> born{faceNormals.data(), 3};
  const std::int32_t length = control.desc.length;
  const BufferDescriptor packed{0, length, length};
  std::vector<Real> points[2];
  Points<Real> source = control;
  for (std::int32_t k = 0; k < last; ++k) {
    const View<const Real> in = viewOf(source);
    for (const Far::FrameBatch& batch : table.frames[at(k)].batches) {
      split(threads_, batch.count, [&](std::int64_t begin, std::int64_t end) {
        Kernels::frames(table.frames[at(k)], batch, in, View<Real>{nullptr, 0}, born, begin, end);
      });
    }
    const Far::LevelTable& step = levels.table(k + 1);
    std::vector<Real>& next = points[k % 2];
    if (k + 1 < last) next.resize(at(length) * at(step.targetCount));
    const PointsOut<Real> target = k + 1 < last ? PointsOut<Real>{next, packed} : refined;
    if (auto done = levels_.evaluate(step, source, target); !done) return done;
    source = {next, packed};
  }
  const View<Real> out = viewOf(normals);
  split(threads_, std::ssize(table.offsets) - 1, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t v = begin; v < end; ++v) {
      const std::int32_t* faces = table.faces.data() + table.offsets[at(v)];
      const std::int32_t count = table.offsets[at(v) + 1] - table.offsets[at(v)];
      Kernels::store(Kernels::normalSum(faces, count, View<const Real>{born.data, born.stride}),
                     out.point(static_cast<std::int32_t>(v)));
    }
  });
  return {};
}

#define HONEYCOMB_INSTANTIATE(Real)                                                                               \
  template Result<void> NormalEvaluator::evaluate(Far::LevelTables, const Far::NormalTable&, const Points<Real>&, \
                                                  const PointsOut<Real>&, const PointsOut<Real>&);
HONEYCOMB_INSTANTIATE(float)
HONEYCOMB_INSTANTIATE(double)
#undef HONEYCOMB_INSTANTIATE

}  // namespace honeycomb::Osd
