#include <Eigen/SparseCore>
#include <memory>

#include "bench/kit/evaluators.h"
#include "far/base/parallel.h"
#include "far/base/stopwatch.h"

namespace honeycomb::Bench {

namespace {

using Sparse = Eigen::SparseMatrix<float, Eigen::RowMajor, std::int32_t>;
/// A point is a row, its length known to the compiler: the form of Eigen's product that is fastest.
template <int Length>
using Dense = Eigen::Matrix<float, Eigen::Dynamic, Length, Eigen::RowMajor>;

std::shared_ptr<const Sparse> matrixOf(const Far::StencilTable& table) {
  return std::make_shared<const Sparse>(
      Eigen::Map<const Sparse>(table.rowCount(), table.sourceCount, static_cast<Eigen::Index>(table.indices.size()),
                               table.offsets.data(), table.indices.data(), table.weightsSingle.data()));
}

template <int Length>
Result<void> multiply(const Sparse& matrix, const Problem& problem) {
  Eigen::setNbThreads(Parallel::threadCount());
  const Eigen::Map<const Dense<Length>> control(problem.control.data(), matrix.cols(), Length);
  Eigen::Map<Dense<Length>> refined(problem.refined.data(), matrix.rows(), Length);
  refined.noalias() = matrix * control;
  return {};
}

}  // namespace

Result<Prepared> prepareEigen(const Problem& problem) {
  if (auto ok = withoutNormals(problem); !ok) return tl::unexpected(ok.error());
  const Result<const Far::StencilTable*> table = problem.flat.get();
  if (!table) return tl::unexpected(table.error());
  const Stopwatch stopwatch;
  const auto matrix = matrixOf(**table);
  Prepared prepared;
  prepared.frame = [matrix, problem] {
    return problem.layout.desc.length == 4 ? multiply<4>(*matrix, problem) : multiply<3>(*matrix, problem);
  };
  prepared.refined = problem.refined;
  prepared.buildMs = problem.tablesMs + problem.flat.buildMs() + stopwatch.milliseconds();
  prepared.tableBytes = (matrix->rows() + 1 + 2 * matrix->nonZeros()) * 4;
  prepared.vertices = problem.refinement.last().topology.vertexCount();
  prepared.spins = true;
  return prepared;
}

}  // namespace honeycomb::Bench
