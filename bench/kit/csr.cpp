#include <memory>

#include "bench/kit/csr_kernel.h"
#include "bench/kit/evaluators.h"
#include "far/base/index.h"
#include "far/base/parallel.h"

namespace honeycomb::Bench {

namespace {

/// About 10 us of work.
constexpr std::int64_t kRowsPerTask = 1024;

/// x y z -> x y z w.
void pad(std::span<const float> packed, std::vector<float>& padded) {
  for (std::size_t v = 0; 3 * v < packed.size(); ++v) std::copy_n(&packed[3 * v], 3, &padded[4 * v]);
}

}  // namespace

Result<Prepared> prepareCsr(const Problem& problem) {
  if (auto ok = withoutNormals(problem); !ok) return tl::unexpected(ok.error());
  const Result<const Far::StencilTable*> table = problem.flat.get();
  if (!table) return tl::unexpected(table.error());
  const std::int32_t stride = problem.layout.desc.stride;
  // Packed points are padded in each frame: that is little beside the rows, which then read whole registers.
  const auto padded = std::make_shared<std::vector<float>>(4 * at((*table)->sourceCount), 0.0F);
  Prepared prepared;
  prepared.frame = [table = *table, stride, padded, rows = csrRows(stride), control = problem.control,
                    refined = problem.refined]() -> Result<void> {
    if (stride == 3) pad(control, *padded);
    const CsrJob job{*table, stride == 3 ? padded->data() : control.data(), refined.data()};
    Parallel::forRange(0, table->rowCount(), kRowsPerTask,
                       [&](std::int64_t begin, std::int64_t end) { rows(job, begin, end); });
    return {};
  };
  prepared.refined = problem.refined;
  prepared.buildMs = problem.tablesMs + problem.flat.buildMs();
  prepared.tableBytes = static_cast<std::int64_t>((*table)->offsets.size() + 2 * (*table)->indices.size()) * 4;
  prepared.vertices = problem.refinement.last().topology.vertexCount();
  return prepared;
}

}  // namespace honeycomb::Bench
