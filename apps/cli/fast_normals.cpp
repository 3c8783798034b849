#include "apps/cli/fast_normals.h"

#include "far/base/index.h"
#include "osd/normal_evaluator.h"

namespace honeycomb::Cli {

template <class Real>
Result<void> setFastNormals(const Far::Refinement& refinement, std::span<const Real> control, Surface<Real>& surface) {
  const Result<Far::NormalTable> table = Far::buildNormalTable(refinement, refinement.levelCount());
  if (!table) return tl::unexpected(table.error());
  surface.normals.resize(surface.points.size());
  Osd::NormalEvaluator evaluator(Osd::CpuEvaluator::Threads::all);
  const Result<void> done =
      evaluator.evaluate<Real>(refinement, *table, Osd::Points<Real>{control, {}},
                               Osd::PointsOut<Real>{surface.points, {}}, Osd::PointsOut<Real>{surface.normals, {}});
  surface.normals.resize(3 * at(surface.vertexCount));  // points that are no vertices have none
  return done;
}
template Result<void> setFastNormals(const Far::Refinement&, std::span<const float>, Surface<float>&);
template Result<void> setFastNormals(const Far::Refinement&, std::span<const double>, Surface<double>&);

}  // namespace honeycomb::Cli
