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

/// Invocations in a workgroup of a GPU: two to four subgroups, so that one runs while another waits for memory, and few
/// enough that small steps keep them busy.
constexpr std::uint32_t kGroupOnGpu = 128;

/// Workgroups at once on a GPU, each with a slice of the scratch and tile after tile: enough for all its cores.
constexpr std::uint64_t kSlicesOnGpu = 1024;

/// Texels of the scratch in front of the slices: the dealer (shaders/tile_slices.glsl). Slices begin at even ones.
constexpr std::uint64_t kFrontTexels = 2;
/// Of a slice, for a tile of `points`: these, the answer, and one more where that makes it even.
constexpr std::uint32_t sliceTexels(std::uint32_t points) {
  return (points + 2) / 2 * 2;
}

std::vector<std::int32_t> chosen(const Far::TileTable& tiles, const VulkanTileOptions& options) {
  if (options.only) return {options.only->begin(), options.only->end()};
  std::vector<std::int32_t> all(tiles.tiles.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

bool onCpu(const VulkanCore& core) {
  return core.type == VK_PHYSICAL_DEVICE_TYPE_CPU;
}

/// On lavapipe a subgroup is a vector; more of them make every barrier a switch of coroutines.
std::uint32_t groupSize(const VulkanCore& core) {
  return std::min(core.limits.groupSize, onCpu(core) ? core.subgroupSize : kGroupOnGpu);
}

/// How many tiles a workgroup may run. Llvmpipe ends a workgroup's loops without a word when all of them together have
/// taken 65,535 turns; other devices don't. Three quarters of that: what is counted are the shader's loops, not the
/// compiler's.
std::uint64_t tilesEach(const VulkanCore& core, const TileImage& image) {
  if (!onCpu(core)) return image.tileCount;
  constexpr std::uint64_t kMostTurns = 65535 / 4 * 3;
  return std::max<std::uint64_t>(1, kMostTurns / (image.turns + 1));
}

/// Slices of the scratch. A CPU runs a workgroup a thread: one each, which then stays in the second-level cache of its
/// core from tile to tile; or as many for each as tilesEach() takes.
std::uint64_t slices(const VulkanCore& core, const TileImage& image) {
  if (!onCpu(core)) return kSlicesOnGpu;
  const std::uint64_t each = tilesEach(core, image);
  const std::uint64_t threads = deviceThreads();
  const std::uint64_t rounds = (image.tileCount + each * threads - 1) / (each * threads);
  return std::max<std::uint64_t>(1, rounds) * threads;
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
  if (shared) return Kernel::tileShared;
  return onCpu(core) && core.device.longStores ? Kernel::tileLong : Kernel::tileBuffer;
}

/// How the kernel writes the image's points: with the fewest stores that the alignment of these allows.
TilePlacing placingOf(const Dispatch& dispatch, const TileImage& image) {
  const Specialization& constants = dispatch.specialization;
  const std::uint32_t offset = dispatch.push.targetOffset;
  const bool pairs = dispatch.kernel == Kernel::tileLong && image.pairs;
  if (constants.length == 4 && (offset | constants.targetStride) % 4 == 0) {
    return pairs && constants.targetStride == 4 && offset % 8 == 0 ? TilePlacing::eights : TilePlacing::whole;
  }
  if (constants.length != 3 || constants.targetStride != 3) return TilePlacing::numbers;
  if (dispatch.kernel == Kernel::tileLong && offset % 3 == 0) {
    return offset % 2 == 0 && pairs ? TilePlacing::sixes : TilePlacing::threes;
  }
  if (offset % 4 == 0 && image.fours) return TilePlacing::fours;
  return offset % 2 == 0 && image.pairs ? TilePlacing::pairs : TilePlacing::numbers;
}

/// All numbers of a point at once: what lavapipe takes for a read is a loop over invocations, too.
bool readsWhole(const Dispatch& dispatch) {
  const Specialization& constants = dispatch.specialization;
  if (dispatch.kernel != Kernel::tileLong || constants.shares != 0) return false;
  const bool packed = constants.length == constants.sourceStride && dispatch.push.sourceOffset % constants.length == 0;
  return packed && (constants.length == 3 || constants.length == 4);
}

/// Errors: invalidOption for normals that there aren't, at this level or of such points.
Result<void> checkTileNormals(const Far::TileTable& tiles, const VulkanTableOptions& table,
                              const BufferDescriptor& normals) {
  if (tiles.normalKind == Far::TileNormalKind::none) {
    return fail(ErrorCode::invalidOption, "the tiles were built without normals; ask for them in TileOptions");
  }
  if (table.lastLevel != tiles.lastLevel) {
    return fail(ErrorCode::invalidOption,
                fmt::format("normals are of level {} alone; level {} was asked for", tiles.lastLevel, table.lastLevel));
  }
  return checkNormalLayout(table.refined, normals);
}

}  // namespace

Result<VulkanTable> TableBuilder::build(Far::LevelTables levels, const Far::TileTable& tiles,
                                        const VulkanTileOptions& options) {
  const std::int32_t level = state_.options.lastLevel;
  state_.controlCount = tiles.pointCount.front();
  state_.refinedCount = tiles.pointCount[at(level)];
  if (normals()) normalKind_ = tiles.normalKind;
  need(PointBuffer::vertexNormals, normalBytes());
  const auto root = addRoot(levels, tiles);
  if (!root) return tl::unexpected(root.error());
  if (level > tiles.rootLevel) {
    if (const auto added = addShared(tiles, *root); !added) return tl::unexpected(added.error());
    if (const auto added = addTiles(tiles, *root, options); !added) return tl::unexpected(added.error());
    state_.levelEnds.push_back(state_.phases.size());
  }
  VulkanTable table;
  table.state_ = std::make_shared<const VulkanTable::State>(std::move(state_));
  return table;
}

void TableBuilder::append(Steps& steps) {
  for (auto& step : steps) state_.phases.push_back(std::move(step));
}

Result<void> TableBuilder::checkPages(const StagePlanner& stage) const {
  if (auto sound = stage.check(); !sound) return sound;
  const VulkanLimits& limits = core_->limits;
  const std::uint64_t most =
      std::max({stage.sourceBytes(), bytesOf(PointBuffer::sharedPoints), bytesOf(PointBuffer::sharedNormals)});
  if (most > limits.pageBytes) {
    return fail(ErrorCode::tooLarge, fmt::format("tiles read {} bytes of points, this Vulkan device binds {} at once: "
                                                 "refine level by level",
                                                 most, limits.pageBytes));
  }
  if (pagesOf(stage.targetBytes(), limits) + pagesOf(normalBytes(), limits) > kSourcePages) {
    return fail(ErrorCode::tooLarge, fmt::format("tiles write {} bytes, this Vulkan device binds {} ranges of {}: "
                                                 "refine level by level",
                                                 stage.targetBytes() + normalBytes(), kSourcePages, limits.pageBytes));
  }
  return {};
}

Result<void> TableBuilder::addTiles(const Far::TileTable& tiles, const Place& root, const VulkanTileOptions& options) {
  const Place target = placeOf(PointBuffer::refined, state_.refinedCount);
  const StagePlanner stage(core_->limits, root.layout, target.layout);
  if (auto sound = checkPages(stage); !sound) return sound;
  TileImageBuilder builder(tiles, state_.options.lastLevel, normalKind_, core_->limits.texels, groupSize(*core_));
  auto images = builder.build(chosen(tiles, options));
  if (!images) return tl::unexpected(images.error());
  const auto dispatch = tileDispatch(tiles, stage, builder.largestTile(), options.scratch);
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
                                            std::uint32_t points, TileScratch scratch) const {
  const std::uint64_t slice = std::uint64_t{points} * kTexelBytes;
  const auto kernel = chooseKernel(*core_, scratch, slice);
  if (!kernel) return tl::unexpected(kernel.error());
  if ((kFrontTexels + sliceTexels(points)) * kTexelBytes > core_->limits.pageBytes) {
    return fail(ErrorCode::tooLarge,
                fmt::format("a tile keeps {} bytes, this Vulkan device binds {}: use smaller tiles "
                            "(TileOptions::scratchPoints) or refine level by level",
                            slice, core_->limits.pageBytes));
  }
  Dispatch dispatch = stage.dispatch(*kernel);
  Specialization& constants = dispatch.specialization;
  constants.workgroupSize = groupSize(*core_);
  // Rounded up, so that meshes share pipelines.
  constexpr std::uint32_t kRounding = 256;
  dispatch.push.firstOutput = sliceTexels(points);
  if (*kernel != Kernel::tileShared) constants.dealt = onCpu(*core_) ? 1 : 0;
  if (*kernel == Kernel::tileShared) {
    constants.scratchPoints = std::min((points + kRounding - 1) / kRounding * kRounding,
                                       core_->limits.sharedBytes / static_cast<std::uint32_t>(kTexelBytes));
  } else if (core_->device.fullSubgroups && constants.workgroupSize == core_->subgroupSize) {
    constants.oneSubgroup = 1;
  }
  constants.shares = tiles.shared.empty() ? 0 : 1;
  dispatch.push.sides = static_cast<std::uint32_t>(stage.target().desc.length);
  setTarget(dispatch, stage);
  rangeOf(dispatch, Slot::indices) = {Role::source, 0, stage.sourceBytes()};
  rangeOf(dispatch, Slot::weights) = {Role::sharedPoints, 0, bytesOf(PointBuffer::sharedPoints)};
  rangeOf(dispatch, Slot::second) = {Role::sharedNormals, 0, bytesOf(PointBuffer::sharedNormals)};
  return dispatch;
}

// Points and normals are both bound as pages, or as one range each.
void TableBuilder::setTarget(Dispatch& dispatch, const StagePlanner& stage) const {
  const VulkanLimits& limits = core_->limits;
  Specialization& constants = dispatch.specialization;
  constants.windowed = 0;
  const bool paged = std::max(stage.targetBytes(), normalBytes()) > limits.pageBytes;
  constants.pageShift = paged ? static_cast<std::uint32_t>(std::countr_zero(limits.pageNumbers())) : 0;
  if (!normals()) return;
  constants.normalPage = static_cast<std::uint32_t>(pagesOf(stage.targetBytes(), limits));
  constants.normalStride = static_cast<std::uint32_t>(normals()->stride);
  dispatch.push.normalOffset = static_cast<std::uint32_t>(normals()->offset);
}

Result<void> TableBuilder::addTileStage(const TileImage& image, const Place& root, Dispatch dispatch) {
  TableStage stage;
  stage.source = root.points;
  stage.paged = PointBuffer::refined;
  stage.pagedBytes = bytesOf(PointBuffer::refined);
  if (normals()) stage.normalPage = dispatch.specialization.normalPage;
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
  dispatch.specialization.cases = static_cast<std::uint32_t>(image.cases);
  dispatch.specialization.otherCases = static_cast<std::uint32_t>(image.cases >> 32U);
  dispatch.specialization.sameWeights = image.sameWeights ? 1 : 0;
  setGroups(dispatch, image);
  if (const auto added = addPieces(dispatch, image); !added) return added;
  state_.stages.push_back(std::move(stage));
  return {};
}

// A point of more than four values is evaluated in pieces, and more tiles than workgroups may run in several
// dispatches, one after the other: all have the same scratch.
Result<void> TableBuilder::addPieces(const Dispatch& whole, const TileImage& image) {
  const std::uint64_t each = tilesEach(*core_, image);
  const std::uint64_t most = whole.groups * each;
  Dispatch dispatch = whole;
  dispatch.push.rowLength = static_cast<std::uint32_t>(std::min<std::uint64_t>(each, image.tileCount));
  for (std::int32_t done = 0; done < state_.options.refined.length; done += kPiece) {
    setPiece(dispatch, whole, image, done);
    const auto pipeline = pipelines_.get(dispatch.kernel, dispatch.specialization);
    if (!pipeline) return tl::unexpected(pipeline.error());
    for (std::uint64_t first = 0; first < image.tileCount; first += most) {
      dispatch.push.firstTask = image.firstTile + static_cast<std::uint32_t>(first);
      dispatch.push.count = static_cast<std::uint32_t>(std::min(most, image.tileCount - first));
      dispatch.groups = std::min(whole.groups, dispatch.push.count);
      state_.phases.push_back({{dispatch, *pipeline, static_cast<std::uint32_t>(state_.stages.size())}});
    }
  }
  return {};
}

void TableBuilder::setGroups(Dispatch& dispatch, const TileImage& image) {
  const VulkanLimits& limits = core_->limits;
  std::uint64_t groups = std::min<std::uint64_t>(dispatch.push.count, limits.groupsInRow);
  if (dispatch.kernel != Kernel::tileShared) {
    const std::uint64_t slice = dispatch.push.firstOutput;
    const std::uint64_t most = std::min<std::uint64_t>(limits.pageBytes / kTexelBytes, limits.texels) - kFrontTexels;
    groups = std::min({groups, slices(*core_, image), most / slice});
    const std::uint64_t bytes = (kFrontTexels + groups * slice) * kTexelBytes;
    need(PointBuffer::tileScratch, bytes);
    rangeOf(dispatch, Slot::target) = {Role::tileScratch, 0, bytes};
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
  constants.packedRoot = readsWhole(dispatch) ? 1 : 0;
  constants.placing = TilePlacing::numbers;
  constants.normalPairs = 0;
  if (constants.pageShift != 0) return;
  constants.placing = placingOf(dispatch, image);
  if (normals() && normals()->stride == 3 && normals()->offset % 2 == 0 && image.pairs) constants.normalPairs = 1;
}

Result<VulkanTable> buildTable(const std::shared_ptr<const VulkanCore>& core, VulkanPipelines& pipelines,
                               Far::LevelTables levels, const Far::TileTable& tiles, const VulkanTileOptions& options) {
  VulkanTableOptions table{.control = options.control, .refined = options.refined};
  table.lastLevel = options.level == 0 ? tiles.lastLevel : options.level;
  if (const auto sound = checkTileLevel(tiles, table.lastLevel); !sound) return tl::unexpected(sound.error());
  if (const auto sound = checkTileChoice(tiles, options.only); !sound) return tl::unexpected(sound.error());
  if (const auto sound = checkDescriptors(table); !sound) return tl::unexpected(sound.error());
  if (options.normals) {
    const auto sound = checkTileNormals(tiles, table, *options.normals);
    if (!sound) return tl::unexpected(sound.error());
    table.vertexLimits.normals = options.normals;
  }
  return TableBuilder(core, pipelines, table).build(levels, tiles, options);
}

}  // namespace honeycomb::Osd
