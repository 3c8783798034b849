#include "osd/vulkan/binding.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "osd/vulkan/commands.h"
#include "osd/vulkan/errors.h"
#include "osd/vulkan/guard.h"
#include "osd/vulkan/texels.h"

namespace honeycomb::Osd {

Result<VulkanBinding> VulkanBinding::create(const std::shared_ptr<const VulkanCore>& core,
                                            const std::shared_ptr<VulkanPipelines>& pipelines, const VulkanTable& table,
                                            const VulkanTargets& targets, const VulkanBindingOptions& options) {
  VulkanBinding binding;
  binding.core_ = core;
  binding.pipelines_ = pipelines;
  binding.table_ = table;
  if (const auto resolved = binding.resolve(targets); !resolved) return tl::unexpected(resolved.error());
  if (const auto made = binding.makeScratch(options.scratchOf); !made) return tl::unexpected(made.error());
  if (const auto made = binding.viewScratch(); !made) return tl::unexpected(made.error());
  if (const auto made = binding.makeSets(); !made) return tl::unexpected(made.error());
  if (options.timing) {
    if (const auto made = binding.makeTimer(); !made) return tl::unexpected(made.error());
  }
  return binding;
}

Result<void> VulkanBinding::resolve(const VulkanTargets& targets) {
  const std::array<std::pair<VulkanRange, const char*>, kCallerBuffers> buffers = {
      {{targets.control, "the control points"},
       {targets.refined, "the refined points"},
       {targets.vertexPositions, "the vertices' limit positions"},
       {targets.vertexNormals, "the vertices' normals"},
       {targets.facePositions, "the faces' limit positions"},
       {targets.faceNormals, "the faces' normals"}}};
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    const std::uint64_t needed = table_.bytesOf(static_cast<PointBuffer>(i));
    if (needed == 0) continue;
    auto sound = checkRange(buffers[i].first, needed, core_->limits.alignment, buffers[i].second);
    if (!sound) return sound;
    ranges_[i] = buffers[i].first;
  }
  return {};
}

Result<void> VulkanBinding::makeScratch(const VulkanBinding* shared) {
  if (shared != nullptr) {
    if (shared->table_.state_ != table_.state_) {
      return fail(ErrorCode::invalidOption, "scratch memory is shared by bindings of different tables");
    }
    scratch_ = shared->scratch_;
    std::ranges::copy(std::span(shared->ranges_).last<kScratchBuffers>(), ranges_.begin() + kCallerBuffers);
    return {};
  }
  auto made = std::make_shared<std::array<VulkanBuffer, kScratchBuffers>>();
  for (std::size_t i = 0; i < kScratchBuffers; ++i) {
    const std::uint64_t needed = table_.bytesOf(static_cast<PointBuffer>(kCallerBuffers + i));
    if (needed == 0) continue;
    constexpr VkBufferUsageFlags kUsage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT |
                                          VK_BUFFER_USAGE_STORAGE_TEXEL_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    auto buffer = VulkanBuffer::create(core_, needed, kUsage, MemoryUse::device);
    if (!buffer) return tl::unexpected(buffer.error());
    (*made)[i] = std::move(*buffer);
    ranges_[kCallerBuffers + i] = (*made)[i].range();
  }
  scratch_ = std::move(made);
  return {};
}

// The points of tiles, as texels.
Result<void> VulkanBinding::viewScratch() {
  const std::uint64_t texels = table_.bytesOf(PointBuffer::tileScratch) / kTexelBytes;
  if (texels == 0) return {};
  const VulkanBuffer& tiles = (*scratch_)[static_cast<std::size_t>(PointBuffer::tileScratch) - kCallerBuffers];
  auto view = viewTexels(*core_, tiles, VK_FORMAT_R32G32B32A32_SFLOAT, texels);
  if (!view) return tl::unexpected(view.error());
  scratchTexels_ = std::move(*view);
  return {};
}

// Dispatches that bind the same ranges share a set: as a rule there is one for each level.
Result<void> VulkanBinding::makeSets() {
  using Key = std::pair<std::uint32_t, BoundRanges>;
  std::map<Key, std::uint32_t> places;
  for (const auto& phase : table_.state_->phases) {
    for (const TableDispatch& one : phase) {
      places.emplace(Key{one.stage, one.dispatch.ranges}, static_cast<std::uint32_t>(places.size()));
    }
  }
  auto made = DescriptorSets::create(*core_, pipelines_->setLayout(), static_cast<std::uint32_t>(places.size()));
  if (!made) return tl::unexpected(made.error());
  sets_ = std::move(*made);
  for (const auto& [key, place] : places) writeSet(sets_.sets[place], table_.state_->stages[key.first], key.second);
  for (const auto& phase : table_.state_->phases) {
    std::vector<Command>& commands = phases_.emplace_back();
    for (const TableDispatch& one : phase) {
      const std::uint32_t place = places.at(Key{one.stage, one.dispatch.ranges});
      commands.push_back({one.pipeline, sets_.sets[place], one.dispatch.push, one.dispatch.groups,
                          one.dispatch.groupRows, one.dispatch.specialization.dealt != 0});
    }
  }
  return {};
}

// What a kernel doesn't use is bound to the begin of its table: every descriptor of a set is valid.
VkDescriptorBufferInfo VulkanBinding::bufferOf(const TableStage& stage, const BoundRange& range) const {
  if (range.size == 0) return {stage.buffer.handle(), 0, std::min(stage.buffer.size(), core_->limits.pageBytes)};
  if (range.role == Role::table) return {stage.buffer.handle(), range.offset, range.size};
  PointBuffer points = PointBuffer::partials;
  if (range.role == Role::target) points = stage.target;
  if (range.role == Role::normals) points = stage.normals;
  if (range.role == Role::source) points = stage.source;
  if (range.role == Role::sharedPoints) points = PointBuffer::sharedPoints;
  if (range.role == Role::sharedNormals) points = PointBuffer::sharedNormals;
  if (range.role == Role::tileScratch) points = PointBuffer::tileScratch;
  const VulkanRange& buffer = ranges_[static_cast<std::size_t>(points)];
  return {buffer.buffer, buffer.offset + range.offset, range.size};
}

// Pages behind the last are bound to the first.
VkDescriptorBufferInfo VulkanBinding::pageOf(const TableStage& stage, std::uint32_t page) const {
  const bool ofNormals = stage.normalPage > 0 && page >= stage.normalPage;
  const PointBuffer points = ofNormals ? stage.normals : stage.paged;
  const std::uint64_t bytes = ofNormals ? table_.bytesOf(stage.normals) : stage.pagedBytes;
  const std::uint64_t begin = (ofNormals ? page - stage.normalPage : page) * core_->limits.pageBytes;
  if (page > 0 && begin >= bytes) return pageOf(stage, 0);
  const VulkanRange& buffer = ranges_[static_cast<std::size_t>(points)];
  return {buffer.buffer, buffer.offset + begin, std::min(core_->limits.pageBytes, bytes - begin)};
}

void VulkanBinding::writeSet(VkDescriptorSet set, const TableStage& stage, const BoundRanges& ranges) const {
  std::array<VkDescriptorBufferInfo, kSourcePages + kSlotCount> buffers{};
  for (std::uint32_t page = 0; page < kSourcePages; ++page) buffers[page] = pageOf(stage, page);
  for (std::uint32_t slot = 0; slot < kSlotCount; ++slot) buffers[kSourcePages + slot] = bufferOf(stage, ranges[slot]);
  std::array<VkWriteDescriptorSet, 1 + kSlotCount> writes{};
  for (std::uint32_t i = 0; i < writes.size(); ++i) {
    writes[i].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    writes[i].dstSet = set;
    writes[i].dstBinding = i;
    writes[i].descriptorCount = i == 0 ? kSourcePages : 1;
    writes[i].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    writes[i].pBufferInfo = &buffers[i == 0 ? 0 : kSourcePages + i - 1];
  }
  core_->vk().vkUpdateDescriptorSets(core_->device.device, static_cast<std::uint32_t>(writes.size()), writes.data(), 0,
                                     nullptr);
  writeTexels(set, kTableTexels, VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER, stage.texels.get());
  writeTexels(set, kScratchTexels, VK_DESCRIPTOR_TYPE_STORAGE_TEXEL_BUFFER, scratchTexels_.get());
}

// Kernels without texels don't name them, so that these descriptors need not be valid.
void VulkanBinding::writeTexels(VkDescriptorSet set, std::uint32_t slot, VkDescriptorType type,
                                VkBufferView view) const {
  if (view == VK_NULL_HANDLE) return;
  VkWriteDescriptorSet write{};
  write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
  write.dstSet = set;
  write.dstBinding = slot;
  write.descriptorCount = 1;
  write.descriptorType = type;
  write.pTexelBufferView = &view;
  core_->vk().vkUpdateDescriptorSets(core_->device.device, 1, &write, 0, nullptr);
}

// Makes what a phase wrote visible to the next, which may also overwrite what it read.
void VulkanBinding::barrier(VkCommandBuffer commands) const {
  memoryBarrier(*core_, commands, {VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_WRITE_BIT},
                {VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT});
}

// No tile was asked for yet.
void VulkanBinding::dealAnew(VkCommandBuffer commands) const {
  constexpr MemoryAccess kTiles{VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                                VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT};
  constexpr MemoryAccess kDealer{VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT};
  const VulkanRange& scratch = ranges_[static_cast<std::size_t>(PointBuffer::tileScratch)];
  memoryBarrier(*core_, commands, kTiles, kDealer);
  core_->vk().vkCmdFillBuffer(commands, scratch.buffer, scratch.offset, sizeof(std::uint32_t), 0);
  memoryBarrier(*core_, commands, kDealer, kTiles);
}

void VulkanBinding::record(VkCommandBuffer commands) const {
  const VulkanFunctions& vk = core_->vk();
  // The scratch may still be in use by the same binding, recorded before.
  barrier(commands);
  if (timer_) timer_->start(commands);
  std::uint32_t part = 0;
  for (std::size_t p = 0; p < phases_.size(); ++p) {
    if (p > 0 && !core_->options.leaveOutBarriers) barrier(commands);
    for (const Command& one : phases_[p]) {
      if (one.dealt) dealAnew(commands);
      vk.vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipelines_->current(one.pipeline));
      vk.vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipelines_->layout(), 0, 1, &one.set, 0,
                                 nullptr);
      vk.vkCmdPushConstants(commands, pipelines_->layout(), VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(one.push),
                            &one.push);
      vk.vkCmdDispatch(commands, one.groups, one.groupRows, 1);
    }
    if (timer_ && timedEnds_[part] == p + 1) timer_->finish(commands, part++);
  }
  // Chosen tiles may be none, and a part without dispatches.
  for (; timer_ && part < timedEnds_.size(); ++part) timer_->finish(commands, part);
}

Result<std::uint64_t> VulkanBinding::refreshKernels() const {
  return guarded([this] { return pipelines_->refresh(); });
}

Result<void> VulkanBinding::makeTimer() {
  timedEnds_ = table_.state_->levelEnds;
  if (timedEnds_.empty() || timedEnds_.back() < phases_.size()) timedEnds_.push_back(phases_.size());
  auto timer = LevelTimer::create(core_, static_cast<std::uint32_t>(timedEnds_.size()));
  if (!timer) return tl::unexpected(timer.error());
  timer_ = std::move(*timer);
  return {};
}

Result<std::vector<LevelTime>> VulkanBinding::levelTimes() const {
  return guarded([this] { return timesOfParts(); });
}

Result<std::vector<LevelTime>> VulkanBinding::timesOfParts() const {
  if (!timer_) {
    return fail(ErrorCode::invalidOption,
                "the times of levels are wanted of a binding without timing: set "
                "VulkanBindingOptions::timing");
  }
  const auto milliseconds = timer_->milliseconds();
  if (!milliseconds) return tl::unexpected(milliseconds.error());
  const auto levels = static_cast<std::int32_t>(table_.state_->levelEnds.size());
  std::vector<LevelTime> times;
  for (std::int32_t part = 0; part < static_cast<std::int32_t>(milliseconds->size()); ++part) {
    const bool limits = part >= levels;
    const std::int32_t level = table_.options().firstLevel + (limits ? levels : part + 1);
    times.push_back({level, limits, (*milliseconds)[static_cast<std::size_t>(part)]});
  }
  return times;
}

std::uint64_t VulkanBinding::scratchBytes() const {
  std::uint64_t bytes = 0;
  for (const VulkanBuffer& buffer : *scratch_) bytes += buffer.size();
  return bytes;
}

}  // namespace honeycomb::Osd
