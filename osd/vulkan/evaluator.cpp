#include "osd/vulkan/evaluator.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "osd/vulkan/guard.h"
#include "osd/vulkan/texels.h"

namespace honeycomb::Osd {

Result<VulkanEvaluator> VulkanEvaluator::create(const VulkanDevice& device, const VulkanEvaluatorOptions& options) {
  return guarded([&]() -> Result<VulkanEvaluator> {
    const auto core = VulkanCore::create(device, options);
    if (!core) return tl::unexpected(core.error());
    VulkanEvaluator evaluator;
    evaluator.core_ = std::make_shared<const VulkanCore>(*core);
    auto pipelines = VulkanPipelines::create(evaluator.core_);
    if (!pipelines) return tl::unexpected(pipelines.error());
    evaluator.pipelines_ = std::move(*pipelines);
    return evaluator;
  });
}

Result<VulkanTable> VulkanEvaluator::uploadRange(Far::LevelTables levels, const Far::NormalTable* fast,
                                                 const VulkanTableOptions& options) {
  const std::int32_t last = options.lastLevel < 0 ? levels.levelCount() : options.lastLevel;
  if (options.firstLevel < 0 || last <= options.firstLevel || last > levels.levelCount()) {
    return fail(ErrorCode::invalidOption,
                fmt::format("levels {} to {} of a refinement with levels 0 to {}: give a range within, "
                            "of at least one step",
                            options.firstLevel, last, levels.levelCount()));
  }
  std::vector<const Far::LevelTable*> tables;
  for (std::int32_t k = options.firstLevel + 1; k <= last; ++k) tables.push_back(&levels.table(k));
  const Far::LimitTable* limits = last == levels.levelCount() ? &levels.limits() : nullptr;
  return uploadLevels(tables, limits, fast, options);
}

Result<VulkanTable> VulkanEvaluator::upload(const Far::Refinement& refinement, const VulkanTableOptions& options) {
  return guarded([&]() -> Result<VulkanTable> {
    if (!options.fastNormals()) return uploadRange(refinement, nullptr, options);
    if (options.firstLevel != 0) {
      return fail(ErrorCode::invalidOption,
                  fmt::format("fast normals of faces are found from level 0 on, not from level {}: begin with level 0, "
                              "or take exact normals",
                              options.firstLevel));
    }
    const std::int32_t last = options.lastLevel < 0 ? refinement.levelCount() : options.lastLevel;
    const Result<Far::NormalTable> fast = Far::buildNormalTable(refinement, last);
    if (!fast) return tl::unexpected(fast.error());
    return uploadRange(refinement, &*fast, options);
  });
}

Result<VulkanTable> VulkanEvaluator::upload(Far::LevelTables levels, const VulkanTableOptions& options) {
  return guarded([&]() -> Result<VulkanTable> { return uploadRange(levels, nullptr, options); });
}

Result<VulkanTable> VulkanEvaluator::upload(std::span<const Far::LevelTable* const> levels,
                                            const Far::LimitTable* limits, const VulkanTableOptions& options) {
  return uploadLevels(levels, limits, nullptr, options);
}

Result<VulkanTable> VulkanEvaluator::uploadLevels(std::span<const Far::LevelTable* const> levels,
                                                  const Far::LimitTable* limits, const Far::NormalTable* fast,
                                                  const VulkanTableOptions& options) {
  auto table =
      guarded([&]() -> Result<VulkanTable> { return buildTable(core_, *pipelines_, levels, limits, fast, options); });
  // A cache that can't be written costs time at the next start, and nothing else.
  if (table) static_cast<void>(savePipelines());
  return table;
}

Result<VulkanTable> VulkanEvaluator::upload(const Far::StencilTable& table, Far::StencilWeights which,
                                            const VulkanTableOptions& options) {
  return guarded([&]() -> Result<VulkanTable> {
    const Far::LevelTable rows = table.asLevelTable(which);
    return upload(std::array{&rows}, nullptr, options);
  });
}

std::int32_t VulkanEvaluator::tilePoints(TileScratch scratch) const {
  const bool cpu = core_->type == VK_PHYSICAL_DEVICE_TYPE_CPU;
  if (scratch == TileScratch::buffer || (scratch == TileScratch::automatic && cpu)) return 30720;
  const std::int64_t shared = core_->limits.sharedBytes / static_cast<std::int64_t>(kTexelBytes);
  return static_cast<std::int32_t>(std::clamp<std::int64_t>(shared * 3 / 4, 64, Far::kMostTilePoints));
}

Far::TileOptions VulkanEvaluator::tileOptions(TileScratch scratch) const {
  constexpr std::int32_t kTilesAThread = 4;
  Far::TileOptions options{.scratchPoints = tilePoints(scratch)};
  if (core_->type != VK_PHYSICAL_DEVICE_TYPE_CPU) return options;
  options.workers = static_cast<std::int32_t>(deviceThreads());
  options.fewestTiles = kTilesAThread * options.workers;
  return options;
}

Result<VulkanTable> VulkanEvaluator::uploadTiles(Far::LevelTables levels, const Far::TileTable& tiles,
                                                 const VulkanTileOptions& options) {
  auto table = guarded([&]() -> Result<VulkanTable> { return buildTable(core_, *pipelines_, levels, tiles, options); });
  if (table) static_cast<void>(savePipelines());
  return table;
}

Result<void> VulkanEvaluator::savePipelines() const {
  return guarded([&]() -> Result<void> { return pipelines_->save(); });
}

Result<VulkanBinding> VulkanEvaluator::bind(const VulkanTable& table, const VulkanTargets& targets,
                                            const VulkanBindingOptions& options) const {
  return guarded(
      [&]() -> Result<VulkanBinding> { return VulkanBinding::create(core_, pipelines_, table, targets, options); });
}

}  // namespace honeycomb::Osd
