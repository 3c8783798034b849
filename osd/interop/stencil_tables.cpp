#include "osd/interop/stencil_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <span>

#include "far/base/index.h"
#include "far/base/parallel.h"

namespace honeycomb::Osd {

namespace {

namespace Foreign = OpenSubdiv::Far;

/// OpenSubdiv lets only its own factories and derived classes fill a table.
class FilledTable : public Foreign::StencilTable {
 public:
  FilledTable(int controlVertices, const std::vector<int>& offsets, const std::vector<int>& sizes,
              const std::vector<int>& sources, const std::vector<float>& weights)
      : StencilTable(controlVertices, offsets, sizes, sources, weights, false, 0) {}
};

/// The first stencil that can't be a row; -1 if all can.
template <class Real>
std::int64_t unsoundStencil(const Foreign::StencilTableReal<Real>& stencils, std::span<const std::int32_t> offsets) {
  const std::vector<int>& sources = stencils.GetControlIndices();
  for (std::size_t r = 0; r + 1 < offsets.size(); ++r) {
    if (offsets[r] == offsets[r + 1] || at(offsets[r + 1]) > sources.size()) return static_cast<std::int64_t>(r);
    for (std::int32_t b = offsets[r]; b < offsets[r + 1]; ++b) {
      const int source = sources[at(b)];
      if (source < 0 || source >= stencils.GetNumControlVertices()) return static_cast<std::int64_t>(r);
    }
  }
  return -1;
}

}  // namespace

Result<std::unique_ptr<const Foreign::StencilTable>> toOpenSubdiv(const Far::StencilTable& table,
                                                                  Far::StencilWeights which) {
  if (which != Far::StencilWeights::position && !table.hasTangents()) {
    return fail(ErrorCode::invalidOption, "the stencil table has no tangents; build one of limits");
  }
  const std::vector<int> offsets(table.offsets.begin(), table.offsets.end() - 1);
  std::vector<int> sizes(offsets.size());
  std::transform(table.offsets.begin() + 1, table.offsets.end(), offsets.begin(), sizes.begin(), std::minus<>());
  const auto weights = table.weightsAs<float>(which);
  return std::make_unique<const FilledTable>(table.sourceCount, offsets, sizes,
                                             std::vector<int>(table.indices.begin(), table.indices.end()),
                                             std::vector<float>(weights.begin(), weights.end()));
}

template <class Real>
Result<Far::LevelTable> fromOpenSubdiv(const Foreign::StencilTableReal<Real>& stencils) {
  Far::LevelTable table;
  table.sourceCount = stencils.GetNumControlVertices();
  table.targetCount = stencils.GetNumStencils();
  Far::LooseRows& rows = table.loose;
  rows.outputs.resize(at(table.targetCount));
  std::iota(rows.outputs.begin(), rows.outputs.end(), 0);
  rows.offsets.assign(stencils.GetSizes().begin(), stencils.GetSizes().end());
  rows.offsets.push_back(0);
  Parallel::exclusiveScan(rows.offsets);
  if (const std::int64_t r = unsoundStencil(stencils, rows.offsets); r >= 0) {
    return fail(ErrorCode::invalidOption,
                fmt::format("stencil {} has no entries or reads a vertex that isn't there; make the table with "
                            "factorised levels",
                            r),
                r);
  }
  // The factories may leave the arrays longer than the stencils are, by what they reserved.
  const std::size_t entries = at(rows.offsets.back());
  table.indices.edit().assign(stencils.GetControlIndices().begin(),
                              stencils.GetControlIndices().begin() + rows.offsets.back());
  table.weights.resize(entries);
  table.weightsSingle.resize(entries);
  Parallel::forEach(0, rows.offsets.back(), [&](std::int64_t b) {
    table.weights[at(b)] = static_cast<double>(stencils.GetWeights()[at(b)]);
    table.weightsSingle[at(b)] = static_cast<float>(stencils.GetWeights()[at(b)]);
  });
  return table;
}

template Result<Far::LevelTable> fromOpenSubdiv(const Foreign::StencilTableReal<float>&);
template Result<Far::LevelTable> fromOpenSubdiv(const Foreign::StencilTableReal<double>&);

}  // namespace honeycomb::Osd
