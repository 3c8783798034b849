#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "osd/piece.h"
#include "osd/vulkan/table_builder.h"

namespace honeycomb::Osd {

std::uint64_t VulkanTable::byteCount() const {
  std::uint64_t bytes = 0;
  for (const TableStage& stage : state_->stages) bytes += stage.buffer.size();
  return bytes;
}

std::size_t VulkanTable::dispatchCount() const {
  std::size_t count = 0;
  for (const auto& phase : state_->phases) count += phase.size();
  return count;
}

namespace {

using Far::LevelTable;
using Far::LimitRows;

Result<void> checkLevels(std::span<const LevelTable* const> levels) {
  if (levels.empty()) return fail(ErrorCode::invalidOption, "a Vulkan table needs at least one level");
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (levels[i]->sourceCount <= 0 || levels[i]->targetCount <= 0) {
      return fail(ErrorCode::invalidOption, fmt::format("level {} of the Vulkan table has no points", i + 1));
    }
    if (i > 0 && levels[i]->sourceCount != levels[i - 1]->targetCount) {
      return fail(ErrorCode::invalidOption,
                  fmt::format("level {} of the Vulkan table reads {} points, the level before has {}", i + 1,
                              levels[i]->sourceCount, levels[i - 1]->targetCount));
    }
  }
  return {};
}

bool wantsLimits(const VulkanTableOptions& options) {
  return !options.exactVertexLimits().empty() || !options.faceLimits.empty();
}

Result<void> checkLimits(const VulkanTableOptions& options, const Far::LimitTable* limits, const LevelTable& last) {
  if (!wantsLimits(options)) return {};
  if (limits == nullptr || limits->faces.sourceCount == 0) {
    return fail(ErrorCode::invalidOption,
                "limits are wanted of a refinement without: set RefineOptions::limits and evaluate to the last level");
  }
  if (limits->faces.sourceCount != last.targetCount) {
    return fail(ErrorCode::invalidOption, fmt::format("the limits read {} points, the last level has {}",
                                                      limits->faces.sourceCount, last.targetCount));
  }
  return {};
}

Result<void> checkFastNormals(const VulkanTableOptions& options) {
  if (!options.vertexLimits.normals) return {};
  if (options.normalKind == Far::TileNormalKind::none) {
    return fail(ErrorCode::invalidOption, "normals are wanted and normalKind is none: make it fast or exact");
  }
  if (options.fastNormals()) return checkNormalLayout(options.refined, *options.vertexLimits.normals);
  return {};
}

}  // namespace

Result<void> checkNormalLayout(const BufferDescriptor& points, const BufferDescriptor& normals) {
  if (points.length < 3 || points.length > kPiece || normals.length != 3) {
    return fail(ErrorCode::invalidOption, "normals (length 3) are of positions: points of length 3 or 4");
  }
  return checkDescriptor(normals, normals.offset, 0, "normals");
}

Result<void> checkDescriptors(const VulkanTableOptions& options) {
  const auto check = [](const BufferDescriptor& desc, const char* what) {
    return checkDescriptor(desc, desc.offset, 0, what);
  };
  if (auto sound = check(options.control, "the control points"); !sound) return sound;
  if (auto sound = check(options.refined, "the refined points"); !sound) return sound;
  if (options.control.length != options.refined.length) {
    return fail(ErrorCode::invalidOption,
                fmt::format("control points have {} values and refined points {}: give both the same "
                            "length",
                            options.control.length, options.refined.length));
  }
  if (auto sound = checkFastNormals(options); !sound) return sound;
  const LimitLayouts vertices = options.exactVertexLimits();
  for (const auto* layouts : {&vertices, &options.faceLimits}) {
    for (const auto* desc : {&layouts->positions, &layouts->normals}) {
      if (!desc->has_value()) continue;
      if (auto sound = check(**desc, "the limits"); !sound) return sound;
      if ((*desc)->length != 3 || options.refined.length != 3) {
        return fail(ErrorCode::invalidOption,
                    "limits are computed of points with 3 values and have 3 values themselves");
      }
    }
  }
  return {};
}

Result<VulkanTable> TableBuilder::build(std::span<const LevelTable* const> levels, const Far::LimitTable* limits,
                                        const Far::NormalTable* fast) {
  state_.controlCount = levels.front()->sourceCount;
  state_.refinedCount = levels.back()->targetCount;
  if (const auto added = addLevels(levels, fast); !added) return tl::unexpected(added.error());
  if (wantsLimits(state_.options)) {
    if (const auto added = addLimits(*limits); !added) return tl::unexpected(added.error());
  }
  VulkanTable table;
  table.state_ = std::make_shared<const VulkanTable::State>(std::move(state_));
  return table;
}

// Scratch points are packed: nothing between one point and the next.
PointLayout TableBuilder::layoutOf(PointBuffer points, std::int64_t count) const {
  if (points == PointBuffer::control) return {state_.options.control, count};
  if (points == PointBuffer::refined) return {state_.options.refined, count};
  if (points == PointBuffer::sharedNormals) return {BufferDescriptor{}, count};
  const std::int32_t length = state_.options.refined.length;
  return {{.offset = 0, .length = length, .stride = length}, count};
}

Result<void> TableBuilder::addLevels(std::span<const LevelTable* const> levels, const Far::NormalTable* fast) {
  PointBuffer source = PointBuffer::control;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const PointBuffer target = i + 1 == levels.size() ? PointBuffer::refined : scratchOf(i);
    auto steps = level(*levels[i], source, target);
    if (!steps) return tl::unexpected(steps.error());
    if (fast != nullptr) {
      const Place points = placeOf(source, levels[i]->sourceCount);
      if (auto joined = joinFaceNormals(*fast, i, points, *steps); !joined) return joined;
    }
    append(*steps);
    state_.levelEnds.push_back(state_.phases.size());
    source = target;
  }
  return fast == nullptr ? Result<void>{} : addNormalSums(*fast);
}

// What reads the refined points goes together; vertices wait for the child level.
Result<void> TableBuilder::addLimits(const Far::LimitTable& limits) {
  const VulkanTableOptions& options = state_.options;
  std::vector<TableDispatch> first;
  if (!options.faceLimits.empty()) {
    state_.faceCount = limits.faces.elementCount;
    auto added = appendFrames(first, limits.faces, options.faceLimits, state_.faceCount, PointBuffer::refined);
    if (!added) return added;
  }
  Steps child;
  std::vector<TableDispatch> last;
  const LimitLayouts wanted = options.exactVertexLimits();
  if (!wanted.empty()) {
    const std::int64_t vertices = limits.vertices.elementCount;
    auto here = appendFrames(first, limits.verticesHere, wanted, vertices, PointBuffer::refined);
    if (!here) return here;
    if (!limits.vertices.batches.empty()) {
      auto steps = level(limits.child, PointBuffer::refined, PointBuffer::scratchEven);
      if (!steps) return tl::unexpected(steps.error());
      child = std::move(*steps);
      auto added = appendFrames(last, limits.vertices, wanted, vertices, PointBuffer::scratchEven);
      if (!added) return added;
    }
  }
  if (!child.empty()) first.insert(first.end(), child.front().begin(), child.front().end());
  state_.phases.push_back(std::move(first));
  for (std::size_t i = 1; i < child.size(); ++i) state_.phases.push_back(std::move(child[i]));
  if (!last.empty()) state_.phases.push_back(std::move(last));
  return {};
}

Result<void> TableBuilder::appendFrames(std::vector<TableDispatch>& phase, const LimitRows& rows,
                                        const LimitLayouts& layouts, std::int64_t results, PointBuffer source) {
  const bool ofFaces = &layouts == &state_.options.faceLimits;
  const PointBuffer positions = ofFaces ? PointBuffer::facePositions : PointBuffer::vertexPositions;
  const PointBuffer normals = ofFaces ? PointBuffer::faceNormals : PointBuffer::vertexNormals;
  if (rows.batches.empty()) return {};
  const auto steps = frames(rows, layouts, results, placeOf(source, rows.sourceCount), positions, normals);
  if (!steps) return tl::unexpected(steps.error());
  phase.insert(phase.end(), steps->front().begin(), steps->front().end());
  return {};
}

Result<TableBuilder::Steps> TableBuilder::level(const LevelTable& table, PointBuffer source, PointBuffer target) {
  return level(table, {source, layoutOf(source, table.sourceCount)}, {target, layoutOf(target, table.targetCount)});
}

Result<TableBuilder::Steps> TableBuilder::level(const LevelTable& table, const Place& source, const Place& target) {
  TableImage image(core_->limits.alignment);
  auto plan = planLevel(core_->limits, table, source.layout, target.layout, image);
  if (!plan) return tl::unexpected(plan.error());
  need(target.points, plan->targetBytes);
  TableStage stage;
  stage.source = source.points;
  stage.target = target.points;
  return addStage(*plan, image, std::move(stage));
}

Result<TableBuilder::Steps> TableBuilder::frames(const LimitRows& rows, const LimitLayouts& layouts,
                                                 std::int64_t results, const Place& source, PointBuffer positions,
                                                 PointBuffer normals) {
  TableImage image(core_->limits.alignment);
  auto plan = planLimits(core_->limits, rows, source.layout, layouts, results, image);
  if (!plan) return tl::unexpected(plan.error());
  need(positions, plan->targetBytes);
  need(normals, plan->normalBytes);
  TableStage stage;
  stage.source = source.points;
  stage.target = positions;
  stage.normals = normals;
  return addStage(*plan, image, std::move(stage));
}

Result<TableBuilder::Steps> TableBuilder::addStage(const StagePlan& plan, const TableImage& image, TableStage stage) {
  need(stage.source, plan.sourceBytes);
  need(PointBuffer::partials, plan.partialBytes);
  stage.paged = stage.source;
  stage.pagedBytes = plan.sourceBytes;
  constexpr VkBufferUsageFlags kUsage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
  auto buffer = VulkanBuffer::create(core_, image.byteCount(), kUsage, MemoryUse::device);
  if (!buffer) return tl::unexpected(buffer.error());
  if (const auto filled = fillBuffer(core_, *buffer, image.pieces()); !filled) return tl::unexpected(filled.error());
  stage.buffer = std::move(*buffer);
  Steps steps;
  for (const auto& planned : plan.steps) {
    std::vector<TableDispatch>& step = steps.emplace_back();
    for (const Dispatch& dispatch : planned) {
      const auto pipeline = pipelines_.get(dispatch.kernel, dispatch.specialization);
      if (!pipeline) return tl::unexpected(pipeline.error());
      step.push_back({dispatch, *pipeline, static_cast<std::uint32_t>(state_.stages.size())});
    }
  }
  state_.stages.push_back(std::move(stage));
  return steps;
}

Result<VulkanTable> buildTable(const std::shared_ptr<const VulkanCore>& core, VulkanPipelines& pipelines,
                               std::span<const LevelTable* const> levels, const Far::LimitTable* limits,
                               const Far::NormalTable* fast, const VulkanTableOptions& options) {
  if (const auto sound = checkLevels(levels); !sound) return tl::unexpected(sound.error());
  if (const auto sound = checkDescriptors(options); !sound) return tl::unexpected(sound.error());
  if (const auto sound = checkLimits(options, limits, *levels.back()); !sound) return tl::unexpected(sound.error());
  if (options.fastNormals() && fast == nullptr) {
    return fail(ErrorCode::invalidOption,
                "fast normals are wanted of levels alone: upload the refinement, or take exact normals");
  }
  return TableBuilder(core, pipelines, options).build(levels, limits, options.fastNormals() ? fast : nullptr);
}

}  // namespace honeycomb::Osd
