#include <fmt/format.h>

#include <bit>
#include <numeric>

#include "far/base/index.h"
#include "osd/piece.h"
#include "osd/tile_checks.h"
#include "osd/vulkan/table_builder.h"
#include "osd/vulkan/texels.h"

namespace honeycomb::Osd {

namespace {

/// Invocations in a workgroup: on lavapipe as many as a vector has, more make every barrier a switch of coroutines.
constexpr std::uint32_t kGroupOnCpu = 8;
constexpr std::uint32_t kGroupOnGpu = 128;

/// Workgroups at once, each with a slice of the scratch and tile after tile: enough for the cores of a device, few
/// enough that slices stay in a cache.
constexpr std::uint64_t kSlices = 1024;

std::vector<std::int32_t> chosen(const Far::TileTable& tiles, const VulkanTileOptions& options) {
  if (options.only) return {options.only->begin(), options.only->end()};
  std::vector<std::int32_t> all(tiles.tiles.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/// Copies runs of points: rows of one entry that weighs 1.
Far::LevelTable copies(std::span<const Far::SharedPoints::Run> runs, std::int32_t sourceCount,
                       std::int32_t targetCount) {
  Far::LevelTable table;
  table.sourceCount = sourceCount;
  table.targetCount = targetCount;
  table.weights = {1};
  table.weightsSingle = {1};
  Array<std::int32_t> indices;
  for (const Far::SharedPoints::Run& run : runs) {
    table.dense.push_back({1, run.count, static_cast<std::int32_t>(indices.size()), run.output, 0});
    for (std::int32_t i = 0; i < run.count; ++i) indices.push_back(run.point + i);
  }
  table.indices = std::move(indices);
  return table;
}

bool onCpu(const VulkanCore& core) {
  return core.type == VK_PHYSICAL_DEVICE_TYPE_CPU;
}

/// Shared memory or a buffer? Errors: tooLarge where shared memory is asked for and holds no tile.
Result<Kernel> chooseKernel(const VulkanCore& core, TileScratch scratch, std::uint64_t bytes) {
  const bool fits = bytes <= core.limits.sharedBytes;
  if (scratch == TileScratch::shared && !fits) {
    return fail(ErrorCode::tooLarge,
                fmt::format("a tile keeps {} bytes, a workgroup of this Vulkan device shares {}: use smaller tiles "
                            "(TileOptions::scratchPoints) or TileScratch::buffer",
                            bytes, core.limits.sharedBytes));
  }
  const bool shared = scratch == TileScratch::shared || (scratch == TileScratch::automatic && fits && !onCpu(core));
  return shared ? Kernel::tileShared : Kernel::tileBuffer;
}

Result<void> checkPages(const VulkanLimits& limits, const StagePlanner& stage, std::uint64_t sharedBytes) {
  if (auto sound = stage.check(); !sound) return sound;
  const std::uint64_t most = std::max(stage.sourceBytes(), sharedBytes);
  if (most > limits.pageBytes) {
    return fail(ErrorCode::tooLarge, fmt::format("tiles read {} bytes of points, this Vulkan device binds {} at once: "
                                                 "refine level by level",
                                                 most, limits.pageBytes));
  }
  if (stage.targetBytes() > kSourcePages * limits.pageBytes) {
    return fail(ErrorCode::tooLarge, fmt::format("tiles write {} bytes, this Vulkan device binds {} ranges of {}: "
                                                 "refine level by level",
                                                 stage.targetBytes(), kSourcePages, limits.pageBytes));
  }
  return {};
}

}  // namespace

Result<VulkanTable> TableBuilder::build(const Far::Refinement& refinement, const Far::TileTable& tiles,
                                        const VulkanTileOptions& options) {
  const std::int32_t level = state_.options.lastLevel;
  state_.controlCount = tiles.pointCount.front();
  state_.refinedCount = tiles.pointCount[at(level)];
  const auto root = addRoot(refinement, tiles, level);
  if (!root) return tl::unexpected(root.error());
  if (level > tiles.rootLevel) {
    if (const auto added = addShared(tiles, level, *root); !added) return tl::unexpected(added.error());
    if (const auto added = addTiles(tiles, level, *root, options); !added) return tl::unexpected(added.error());
    state_.levelEnds.push_back(state_.phases.size());
  }
  VulkanTable table;
  table.state_ = std::make_shared<const VulkanTable::State>(std::move(state_));
  return table;
}

// The root level; the wanted one where that is no later.
Result<TableBuilder::Place> TableBuilder::addRoot(const Far::Refinement& refinement, const Far::TileTable& tiles,
                                                  std::int32_t level) {
  std::vector<const Far::LevelTable*> levels;
  for (std::int32_t k = 1; k <= std::min(level, tiles.rootLevel); ++k) levels.push_back(&refinement.level(k).table);
  if (levels.empty()) return placeOf(PointBuffer::control, tiles.rootPoints);
  const PointBuffer last = level <= tiles.rootLevel ? PointBuffer::refined : scratchOf(levels.size() - 1);
  if (const auto added = addLevels(levels, last); !added) return tl::unexpected(added.error());
  return placeOf(last, levels.back()->targetCount);
}

// Set after set, each from the one before, with the points for the tiles, or those that no tile writes, copied.
Result<void> TableBuilder::addShared(const Far::TileTable& tiles, std::int32_t level, Place source) {
  for (std::int32_t k = tiles.rootLevel + 1; k <= level && !tiles.shared.empty(); ++k) {
    const Far::SharedPoints& set = tiles.shared[static_cast<std::size_t>(k - tiles.rootLevel - 1)];
    const std::int32_t count = set.table.targetCount;
    const Place target = placeOf(k % 2 == 0 ? PointBuffer::setEven : PointBuffer::setOdd, count);
    if (count > 0) {
      auto steps = this->level(set.table, source, target);
      if (!steps) return tl::unexpected(steps.error());
      append(*steps);
    }
    source = target;
    const std::vector<Far::SharedPoints::Run> all = {{0, 0, count}};
    const auto& runs = k < level ? all : set.written;
    if (count == 0 || runs.empty()) continue;
    Place copy = placeOf(PointBuffer::refined, tiles.pointCount[static_cast<std::size_t>(level)]);
    if (k < level) copy = placeOf(PointBuffer::sharedPoints, count);
    if (k < level) copy.layout.desc.offset = set.firstPoint * state_.options.refined.length;
    auto steps = this->level(copies(runs, count, static_cast<std::int32_t>(copy.layout.count)), target, copy);
    if (!steps) return tl::unexpected(steps.error());
    append(*steps);
  }
  return {};
}

void TableBuilder::append(Steps& steps) {
  for (auto& step : steps) state_.phases.push_back(std::move(step));
}

Result<void> TableBuilder::addTiles(const Far::TileTable& tiles, std::int32_t level, const Place& root,
                                    const VulkanTileOptions& options) {
  const Place target = placeOf(PointBuffer::refined, state_.refinedCount);
  const StagePlanner stage(core_->limits, root.layout, target.layout);
  const std::uint64_t sharedBytes = state_.bytes[static_cast<std::size_t>(PointBuffer::sharedPoints)];
  if (auto sound = checkPages(core_->limits, stage, sharedBytes); !sound) return sound;
  auto images = TileImageBuilder(tiles, level, core_->limits.texels).build(chosen(tiles, options));
  if (!images) return tl::unexpected(images.error());
  const auto dispatch = tileDispatch(tiles, stage, options.scratch);
  if (!dispatch) return tl::unexpected(dispatch.error());
  need(root.points, stage.sourceBytes());
  need(PointBuffer::refined, stage.targetBytes());
  for (const TileImage& image : *images) {
    if (auto added = addTileStage(image, root, *dispatch); !added) return added;
  }
  return {};
}

// What is the same of all dispatches of tiles.
Result<Dispatch> TableBuilder::tileDispatch(const Far::TileTable& tiles, const StagePlanner& stage,
                                            TileScratch scratch) const {
  const std::uint64_t slice = static_cast<std::uint64_t>(tiles.largestTile) * kTexelBytes;
  const auto kernel = chooseKernel(*core_, scratch, slice);
  if (!kernel) return tl::unexpected(kernel.error());
  if (slice > core_->limits.pageBytes) {
    return fail(ErrorCode::tooLarge,
                fmt::format("a tile keeps {} bytes, this Vulkan device binds {}: use smaller tiles "
                            "(TileOptions::scratchPoints) or refine level by level",
                            slice, core_->limits.pageBytes));
  }
  Dispatch dispatch = stage.dispatch(*kernel);
  dispatch.specialization.workgroupSize = std::min(core_->limits.groupSize, onCpu(*core_) ? kGroupOnCpu : kGroupOnGpu);
  // Rounded up, so that meshes share pipelines.
  constexpr std::uint32_t kRounding = 256;
  const auto points = static_cast<std::uint32_t>(tiles.largestTile);
  dispatch.push.firstOutput = points;
  if (*kernel == Kernel::tileShared) {
    dispatch.specialization.scratchPoints =
        std::min((points + kRounding - 1) / kRounding * kRounding,
                 core_->limits.sharedBytes / static_cast<std::uint32_t>(kTexelBytes));
  }
  dispatch.specialization.shares = tiles.shared.empty() ? 0 : 1;
  dispatch.specialization.windowed = 0;
  const bool paged = stage.targetBytes() > core_->limits.pageBytes;
  dispatch.specialization.pageShift =
      paged ? static_cast<std::uint32_t>(std::countr_zero(core_->limits.pageNumbers())) : 0;
  dispatch.push.sides = static_cast<std::uint32_t>(stage.target().desc.length);
  rangeOf(dispatch, Slot::indices) = {Role::source, 0, stage.sourceBytes()};
  rangeOf(dispatch, Slot::weights) = {Role::sharedPoints, 0,
                                      state_.bytes[static_cast<std::size_t>(PointBuffer::sharedPoints)]};
  return dispatch;
}

// A point of more than four values is evaluated in pieces, one after the other: all have the same scratch.
Result<void> TableBuilder::addTileStage(const TileImage& image, const Place& root, Dispatch dispatch) {
  TableStage stage;
  stage.source = root.points;
  stage.paged = PointBuffer::refined;
  stage.pagedBytes = state_.bytes[static_cast<std::size_t>(PointBuffer::refined)];
  constexpr VkBufferUsageFlags kUsage =
      VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT;
  const BufferPiece words{0, std::as_bytes(std::span(image.words))};
  auto buffer = VulkanBuffer::create(core_, words.bytes.size(), kUsage, MemoryUse::device);
  if (!buffer) return tl::unexpected(buffer.error());
  if (const auto filled = fillBuffer(core_, *buffer, {&words, 1}); !filled) return tl::unexpected(filled.error());
  auto texels = viewTexels(*core_, *buffer, VK_FORMAT_R32G32B32A32_UINT, words.bytes.size() / kTexelBytes);
  if (!texels) return tl::unexpected(texels.error());
  stage.buffer = std::move(*buffer);
  stage.texels = std::move(*texels);
  dispatch.push.count = image.tileCount;
  dispatch.push.firstTask = image.firstTile;
  dispatch.specialization.cases = image.cases;
  setGroups(dispatch);
  const Dispatch whole = dispatch;
  const std::int32_t length = state_.options.refined.length;
  for (std::int32_t done = 0; done < length; done += kPiece) {
    setPiece(dispatch, whole, image, done);
    const auto pipeline = pipelines_.get(dispatch.kernel, dispatch.specialization);
    if (!pipeline) return tl::unexpected(pipeline.error());
    state_.phases.push_back({{dispatch, *pipeline, static_cast<std::uint32_t>(state_.stages.size())}});
  }
  state_.stages.push_back(std::move(stage));
  return {};
}

void TableBuilder::setGroups(Dispatch& dispatch) {
  const VulkanLimits& limits = core_->limits;
  std::uint64_t groups = std::min<std::uint64_t>(dispatch.push.count, limits.groupsInRow);
  if (dispatch.kernel == Kernel::tileBuffer) {
    const std::uint64_t slice = dispatch.push.firstOutput;
    groups = std::min({groups, kSlices, limits.pageBytes / kTexelBytes / slice, limits.texels / slice});
    need(PointBuffer::tileScratch, groups * slice * kTexelBytes);
    rangeOf(dispatch, Slot::target) = {Role::tileScratch, 0, groups * slice * kTexelBytes};
  }
  dispatch.groups = static_cast<std::uint32_t>(groups);
}

// Values `first` .. of every point, as many as a piece has.
void TableBuilder::setPiece(Dispatch& dispatch, const Dispatch& whole, const TileImage& image,
                            std::int32_t first) const {
  const auto begin = static_cast<std::uint32_t>(first);
  Specialization& constants = dispatch.specialization;
  constants.length = static_cast<std::uint32_t>(std::min(kPiece, state_.options.refined.length - first));
  dispatch.push.sourceOffset = whole.push.sourceOffset + begin;
  dispatch.push.targetOffset = whole.push.targetOffset + begin;
  dispatch.push.firstRecord = begin;
  constants.placing = TilePlacing::numbers;
  if (constants.pageShift != 0) return;
  const std::uint32_t offset = dispatch.push.targetOffset;
  if (constants.length == 4 && (offset | constants.targetStride) % 4 == 0) constants.placing = TilePlacing::whole;
  const bool packed = constants.length == 3 && constants.targetStride == 3;
  if (packed && offset % 2 == 0 && image.pairs) constants.placing = TilePlacing::pairs;
}

Result<VulkanTable> buildTable(const std::shared_ptr<const VulkanCore>& core, VulkanPipelines& pipelines,
                               const Far::Refinement& refinement, const Far::TileTable& tiles,
                               const VulkanTileOptions& options) {
  VulkanTableOptions table{.control = options.control, .refined = options.refined};
  table.lastLevel = options.level == 0 ? tiles.lastLevel : options.level;
  if (const auto sound = checkTileLevel(tiles, table.lastLevel); !sound) return tl::unexpected(sound.error());
  if (const auto sound = checkTileChoice(tiles, options.only); !sound) return tl::unexpected(sound.error());
  if (const auto sound = checkDescriptors(table); !sound) return tl::unexpected(sound.error());
  return TableBuilder(core, pipelines, table).build(refinement, tiles, options);
}

}  // namespace honeycomb::Osd
