#include "osd/vulkan/pipelines.h"

#include "osd/vulkan/errors.h"
#include "osd/vulkan/pruned_code.h"

namespace honeycomb::Osd {

namespace {
#include "shaders/circulant.comp.h"
#include "shaders/dense.comp.h"
#include "shaders/least.comp.h"
#include "shaders/limits.comp.h"
#include "shaders/loose.comp.h"
#include "shaders/normals.comp.h"
#include "shaders/projected.comp.h"
#include "shaders/projected_blocks.comp.h"
#include "shaders/projected_sums.comp.h"
#include "shaders/scan_pieces.comp.h"
#include "shaders/scan_sums.comp.h"
#include "shaders/sort_counts.comp.h"
#include "shaders/sort_places.comp.h"
#include "shaders/summed.comp.h"
#include "shaders/tile_buffer.comp.h"
#include "shaders/tile_long.comp.h"
#include "shaders/tile_shared.comp.h"
#include "shaders/zip_around.comp.h"
#include "shaders/zip_face_of.comp.h"
#include "shaders/zip_hexagons.comp.h"
#include "shaders/zip_loops.comp.h"
#include "shaders/zip_numbers.comp.h"
#include "shaders/zip_places.comp.h"
#include "shaders/zip_turns.comp.h"
#include "shaders/zip_twins.comp.h"
}  // namespace

std::span<const std::uint32_t> kernelCode(Kernel kernel) {
  switch (kernel) {
    case Kernel::circulant:
      return kCirculantComp;
    case Kernel::projectedBlocks:
      return kProjectedBlocksComp;
    case Kernel::projectedSums:
      return kProjectedSumsComp;
    case Kernel::projected:
      return kProjectedComp;
    case Kernel::dense:
      return kDenseComp;
    case Kernel::summed:
      return kSummedComp;
    case Kernel::loose:
      return kLooseComp;
    case Kernel::normals:
      return kNormalsComp;
    case Kernel::tileBuffer:
      return kTileBufferComp;
    case Kernel::tileLong:
      return kTileLongComp;
    case Kernel::tileShared:
      return kTileSharedComp;
    case Kernel::zipFaceOf:
      return kZipFaceOfComp;
    case Kernel::zipAround:
      return kZipAroundComp;
    case Kernel::zipTurns:
      return kZipTurnsComp;
    case Kernel::least:
      return kLeastComp;
    case Kernel::scanSums:
      return kScanSumsComp;
    case Kernel::scanPieces:
      return kScanPiecesComp;
    case Kernel::sortCounts:
      return kSortCountsComp;
    case Kernel::sortPlaces:
      return kSortPlacesComp;
    case Kernel::zipPlaces:
      return kZipPlacesComp;
    case Kernel::zipLoops:
      return kZipLoopsComp;
    case Kernel::zipNumbers:
      return kZipNumbersComp;
    case Kernel::zipHexagons:
      return kZipHexagonsComp;
    case Kernel::zipTwins:
      return kZipTwinsComp;
    default:
      return kLimitsComp;
  }
}

Result<std::unique_ptr<VulkanPipelines>> VulkanPipelines::create(std::shared_ptr<const VulkanCore> core) {
  std::unique_ptr<VulkanPipelines> pipelines(new VulkanPipelines(std::move(core)));
  if (const auto made = pipelines->makeSetLayout(); !made) return tl::unexpected(made.error());
  if (const auto made = pipelines->makeLayout(); !made) return tl::unexpected(made.error());
  auto cache = PipelineCache::open(pipelines->core_, pipelines->core_->options.pipelineCache);
  if (!cache) return tl::unexpected(cache.error());
  pipelines->cache_ = std::move(*cache);
  auto files = KernelFiles::watch(pipelines->core_->options.kernelFolder);
  if (!files) return tl::unexpected(files.error());
  pipelines->files_ = std::move(*files);
  if (const auto fresh = pipelines->refresh(); !fresh) return tl::unexpected(fresh.error());
  return pipelines;
}

Result<void> VulkanPipelines::makeSetLayout() {
  std::array<VkDescriptorSetLayoutBinding, 3 + kSlotCount> bindings{};
  for (std::uint32_t i = 0; i < bindings.size(); ++i) {
    bindings[i].binding = i;
    bindings[i].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    bindings[i].descriptorCount = i == 0 ? kSourcePages : 1;
    bindings[i].stageFlags = VK_SHADER_STAGE_COMPUTE_BIT;
  }
  bindings[kTableTexels].descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
  bindings[kScratchTexels].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_TEXEL_BUFFER;
  VkDescriptorSetLayoutCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
  info.bindingCount = static_cast<std::uint32_t>(bindings.size());
  info.pBindings = bindings.data();
  auto layout = core_->make(core_->vk().vkCreateDescriptorSetLayout, core_->vk().vkDestroyDescriptorSetLayout, info,
                            "create a descriptor set layout");
  if (!layout) return tl::unexpected(layout.error());
  setLayout_ = std::move(*layout);
  return {};
}

Result<void> VulkanPipelines::makeLayout() {
  const VkPushConstantRange push{VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(PushConstants)};
  const VkDescriptorSetLayout set = setLayout_.get();
  VkPipelineLayoutCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
  info.setLayoutCount = 1;
  info.pSetLayouts = &set;
  info.pushConstantRangeCount = 1;
  info.pPushConstantRanges = &push;
  auto layout = core_->make(core_->vk().vkCreatePipelineLayout, core_->vk().vkDestroyPipelineLayout, info,
                            "create a pipeline layout");
  if (!layout) return tl::unexpected(layout.error());
  layout_ = std::move(*layout);
  return {};
}

Result<DeviceHandle<VkShaderModule>> VulkanPipelines::makeModule(std::span<const std::uint32_t> code) const {
  VkShaderModuleCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
  info.codeSize = code.size_bytes();
  info.pCode = code.data();
  return core_->make(core_->vk().vkCreateShaderModule, core_->vk().vkDestroyShaderModule, info,
                     "create a shader module");
}

std::span<const std::uint32_t> VulkanPipelines::code(Kernel kernel) const {
  const std::vector<std::uint32_t>& loaded = loaded_[static_cast<std::size_t>(kernel)];
  return loaded.empty() ? kernelCode(kernel) : loaded;
}

Result<std::uint64_t> VulkanPipelines::refresh() {
  const std::lock_guard lock(mutex_);
  auto changed = files_.changed();
  if (!changed) return tl::unexpected(changed.error());
  for (ChangedKernel& one : *changed) {
    loaded_[static_cast<std::size_t>(one.kernel)] = std::move(one.code);
    if (const auto made = remake(one.kernel); !made) return tl::unexpected(made.error());
    ++generation_;
  }
  return generation_;
}

Result<void> VulkanPipelines::remake(Kernel kernel) {
  for (const auto& [key, first] : pipelines_) {
    if (key.first != kernel) continue;
    auto made = make(prunedCode(code(kernel), key.second), key.second);
    if (!made) return tl::unexpected(made.error());
    DeviceHandle<VkPipeline>& place = replaced_[first.get()];
    outdated_.push_back(std::exchange(place, std::move(*made)));
  }
  return {};
}

VkPipeline VulkanPipelines::current(VkPipeline first) {
  const std::lock_guard lock(mutex_);
  const auto found = replaced_.find(first);
  return found == replaced_.end() ? first : found->second.get();
}

Result<VkPipeline> VulkanPipelines::get(Kernel kernel, const Specialization& specialization) {
  const std::pair key{kernel, specialization};
  std::unique_lock lock(mutex_);
  for (;;) {
    if (const auto found = pipelines_.find(key); found != pipelines_.end()) return found->second.get();
    const std::uint64_t before = generation_;
    const std::vector<std::uint32_t> wanted = prunedCode(code(kernel), specialization);
    // Compiling takes seconds with some drivers, and other threads record frames meanwhile.
    lock.unlock();
    auto pipeline = make(wanted, specialization);
    lock.lock();
    if (!pipeline) return tl::unexpected(pipeline.error());
    if (generation_ == before) return pipelines_.emplace(key, std::move(*pipeline)).first->second.get();
  }
}

std::size_t VulkanPipelines::count() const {
  const std::lock_guard lock(mutex_);
  return pipelines_.size();
}

Result<void> VulkanPipelines::save() {
  const std::lock_guard lock(mutex_);
  if (saved_ == pipelines_.size()) return {};
  const auto saved = cache_.save();
  if (saved) saved_ = pipelines_.size();
  return saved;
}

Result<DeviceHandle<VkPipeline>> VulkanPipelines::make(std::span<const std::uint32_t> code,
                                                       const Specialization& specialization) const {
  std::array<VkSpecializationMapEntry, kSpecializationCount> entries{};
  for (std::uint32_t i = 0; i < kSpecializationCount; ++i) {
    entries[i] = {i, static_cast<std::uint32_t>(i * sizeof(std::uint32_t)), sizeof(std::uint32_t)};
  }
  const VkSpecializationInfo constants{kSpecializationCount, entries.data(), sizeof(specialization), &specialization};
  const auto module = makeModule(code);
  if (!module) return tl::unexpected(module.error());
  VkComputePipelineCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
  info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
  info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
  if (specialization.oneSubgroup != 0) {
    info.stage.flags = VK_PIPELINE_SHADER_STAGE_CREATE_REQUIRE_FULL_SUBGROUPS_BIT;
  }
  info.stage.module = module->get();
  info.stage.pName = "main";
  info.stage.pSpecializationInfo = &constants;
  info.layout = layout_.get();
  VkPipeline pipeline = VK_NULL_HANDLE;
  const VkResult result = core_->vk().vkCreateComputePipelines(core_->device.device, cache_.handle(), 1, &info,
                                                               core_->device.allocator, &pipeline);
  if (result != VK_SUCCESS) return vulkanFailure(result, "create a compute pipeline");
  return core_->own(pipeline, core_->vk().vkDestroyPipeline);
}

}  // namespace honeycomb::Osd
