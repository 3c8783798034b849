#include "far/tables/stencil_table.h"

#include <fmt/format.h>

#include <limits>
#include <numeric>

#include "far/base/bytes.h"
#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/tables/stencil_chain.h"
#include "far/tables/stencil_choice.h"

namespace honeycomb::Far {

namespace {

constexpr std::int64_t kMostEntries = std::numeric_limits<std::int32_t>::max();

std::vector<float> rounded(const std::vector<double>& values) {
  std::vector<float> single(values.size());
  Parallel::forEach(0, static_cast<std::int64_t>(values.size()),
                    [&](std::int64_t i) { single[at(i)] = static_cast<float>(values[at(i)]); });
  return single;
}

/// Entries that fit: into 32-bit offsets, and into the memory allowed.
std::int64_t mostEntries(const StencilOptions& options, std::size_t rows) {
  if (options.memoryLimit <= 0) return kMostEntries;
  const std::int64_t lanes = options.kind == StencilKind::points ? 1 : 3;
  const std::int64_t entry = 4 + lanes * static_cast<std::int64_t>(sizeof(double) + sizeof(float));
  return std::min(kMostEntries, (options.memoryLimit - 8 * static_cast<std::int64_t>(rows)) / entry);
}

tl::unexpected<Error> tooManyEntries(const StencilOptions& options, std::int32_t level, std::int64_t most) {
  if (most == kMostEntries) {
    return fail(ErrorCode::tooLarge,
                fmt::format("the stencils of level {} have more than 2^31 - 1 entries; choose fewer faces or vertices, "
                            "or a lower level",
                            level),
                level);
  }
  return fail(ErrorCode::tooLarge,
              fmt::format("the stencils of level {} take more than the {} bytes allowed; choose fewer faces or "
                          "vertices, a lower level, or allow more",
                          level, options.memoryLimit),
              level);
}

/// The level whose points or limits are asked for.
Result<std::int32_t> levelOf(const Refinement& refinement, const StencilOptions& options) {
  const std::int32_t last = refinement.levelCount();
  if (options.kind != StencilKind::points) {
    if (refinement.limits().faces.elementCount > 0) return last;
    return fail(ErrorCode::invalidOption, "the refinement was built without limits; ask for them with RefineOptions");
  }
  if (last == 0) return fail(ErrorCode::invalidOption, "stencils need a level; refine by at least one");
  if (options.level < 0 || options.level > last) {
    return fail(ErrorCode::invalidOption, fmt::format("level {} is out of range; use 1 to {}", options.level, last),
                options.level);
  }
  return options.level == 0 ? last : options.level;
}

/// The tables that lead from what the rows start from to the control points, the last first.
std::vector<const LevelTable*> tablesOf(const Refinement& refinement, StencilKind kind, std::int32_t level) {
  std::vector<const LevelTable*> tables;
  if (kind == StencilKind::vertexLimits) tables.push_back(&refinement.limits().child);
  for (std::int32_t k = level; k > 0; --k) tables.push_back(&refinement.level(k).table);
  return tables;
}

std::vector<FrameIndex> framesOf(const LimitTable& limits, StencilKind kind) {
  std::vector<FrameIndex> frames;
  if (kind == StencilKind::faceLimits) frames.emplace_back(limits.faces);
  if (kind == StencilKind::vertexLimits) {
    frames.reserve(2);
    frames.emplace_back(limits.vertices);
    frames.emplace_back(limits.verticesHere);
  }
  return frames;
}

StencilTable filled(const StencilStart& start, std::vector<std::int32_t> outputs, StencilEntries entries,
                    std::int32_t sourceCount) {
  StencilTable table;
  table.sourceCount = sourceCount;
  table.outputs = std::move(outputs);
  if (start.ofLimits()) {
    fillEntries<3>(start, table.outputs, entries, {&table.weights, &table.tangent1, &table.tangent2});
  } else {
    fillEntries<1>(start, table.outputs, entries, {&table.weights});
  }
  table.offsets = std::move(entries.offsets);
  table.indices = std::move(entries.indices);
  table.weightsSingle = rounded(table.weights);
  table.tangent1Single = rounded(table.tangent1);
  table.tangent2Single = rounded(table.tangent2);
  return table;
}

}  // namespace

Result<StencilTable> StencilTable::build(const Refinement& refinement, const StencilOptions& options) {
  const Result<std::int32_t> level = levelOf(refinement, options);
  if (!level) return tl::unexpected(level.error());
  const Level& target = refinement.level(*level);
  Result<std::vector<std::int32_t>> outputs =
      stencilOutputs(target.topology, *level, target.table.targetCount, options);
  if (!outputs) return tl::unexpected(outputs.error());

  const std::int64_t most = mostEntries(options, outputs->size());
  const std::vector<FrameIndex> frames = framesOf(refinement.limits(), options.kind);
  StencilChain chain(tablesOf(refinement, options.kind, *level), frames);
  // A few rows may well need more entries of the levels between than they have themselves.
  const bool all = options.choice.of == StencilChoice::Of::all;
  StencilEntries entries;
  if (!chain.fold(*outputs, all ? most : kMostEntries) || !countEntries(chain.start(), *outputs, most, entries)) {
    return tooManyEntries(options, *level, most);
  }
  return filled(chain.start(), std::move(*outputs), std::move(entries), refinement.level(1).table.sourceCount);
}

LevelTable StencilTable::asLevelTable(StencilWeights which) const {
  LevelTable table;
  table.sourceCount = sourceCount;
  table.targetCount = rowCount();
  table.loose.outputs.resize(outputs.size());
  std::iota(table.loose.outputs.begin(), table.loose.outputs.end(), 0);
  table.loose.offsets.assign(offsets.begin(), offsets.end());
  table.indices = indices;
  const std::span<const double> exact = weightsAs<double>(which);
  const std::span<const float> single = weightsAs<float>(which);
  table.weights.assign(exact.begin(), exact.end());
  table.weightsSingle.assign(single.begin(), single.end());
  return table;
}

std::int64_t StencilTable::byteCount() const {
  return bytes(outputs) + bytes(offsets) + bytes(indices) + bytes(weights) + bytes(weightsSingle) + bytes(tangent1) +
         bytes(tangent2) + bytes(tangent1Single) + bytes(tangent2Single);
}

}  // namespace honeycomb::Far
