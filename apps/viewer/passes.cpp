#include "apps/viewer/passes.h"

#include <array>

namespace honeycomb::Viewer {
namespace {

VkAttachmentDescription attachment(VkFormat format, VkSampleCountFlagBits samples, bool kept, VkImageLayout after) {
  VkAttachmentDescription description{};
  description.format = format;
  description.samples = samples;
  description.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
  description.storeOp = kept ? VK_ATTACHMENT_STORE_OP_STORE : VK_ATTACHMENT_STORE_OP_DONT_CARE;
  description.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
  description.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
  description.initialLayout = VK_IMAGE_LAYOUT_UNDEFINED;
  description.finalLayout = after;
  return description;
}

/// One side of a dependency.
struct Scope {
  VkPipelineStageFlags stages;
  VkAccessFlags access;
};

VkSubpassDependency before(Scope earlier, Scope ours) {
  return {VK_SUBPASS_EXTERNAL, 0, earlier.stages, ours.stages, earlier.access, ours.access, 0};
}

VkSubpassDependency after(Scope ours, Scope later) {
  return {0, VK_SUBPASS_EXTERNAL, ours.stages, later.stages, ours.access, later.access, 0};
}

Owned<VkRenderPass> makePass(Maker& make, const Gpu& gpu, std::span<const VkAttachmentDescription> attachments,
                             const VkSubpassDescription& subpass, std::span<const VkSubpassDependency> dependencies) {
  auto info = structure<VkRenderPassCreateInfo>(VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO);
  info.attachmentCount = static_cast<std::uint32_t>(attachments.size());
  info.pAttachments = attachments.data();
  info.subpassCount = 1;
  info.pSubpasses = &subpass;
  info.dependencyCount = static_cast<std::uint32_t>(dependencies.size());
  info.pDependencies = dependencies.data();
  return make.own(gpu.call.vkCreateRenderPass, gpu.call.vkDestroyRenderPass, info, "create a render pass");
}

constexpr VkPipelineStageFlags kDepthStages =
    VK_PIPELINE_STAGE_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_LATE_FRAGMENT_TESTS_BIT;
constexpr VkAccessFlags kDepthAccess =
    VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;

}  // namespace

Owned<VkRenderPass> makeShadowPass(Maker& make, const Gpu& gpu) {
  const std::array attachments{
      attachment(kShadowFormat, VK_SAMPLE_COUNT_1_BIT, true, VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL)};
  const VkAttachmentReference depth{0, VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL};
  VkSubpassDescription subpass{};
  subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
  subpass.pDepthStencilAttachment = &depth;
  const Scope sampled{VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT};
  const std::array dependencies{before(sampled, {kDepthStages, kDepthAccess}),
                                after({kDepthStages, VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT}, sampled)};
  return makePass(make, gpu, attachments, subpass, dependencies);
}

Owned<VkRenderPass> makePicturePass(Maker& make, const Gpu& gpu, const PictureFormats& formats) {
  std::array attachments{attachment(formats.colour, kSamples, false, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL),
                         attachment(formats.depth, kSamples, false, VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL),
                         attachment(formats.colour, VK_SAMPLE_COUNT_1_BIT, true, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL)};
  attachments[2].loadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
  const VkAttachmentReference colour{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
  const VkAttachmentReference depth{1, VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL};
  const VkAttachmentReference resolved{2, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
  VkSubpassDescription subpass{};
  subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
  subpass.colorAttachmentCount = 1;
  subpass.pColorAttachments = &colour;
  subpass.pResolveAttachments = &resolved;
  subpass.pDepthStencilAttachment = &depth;
  const VkPipelineStageFlags drawn = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT | kDepthStages;
  const VkAccessFlags access = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT | kDepthAccess;
  const Scope copied{VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_READ_BIT};
  const Scope used{drawn | VK_PIPELINE_STAGE_TRANSFER_BIT, access | VK_ACCESS_TRANSFER_READ_BIT};
  const std::array dependencies{
      before(used, {drawn, access}),
      after({VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT, VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT}, copied)};
  return makePass(make, gpu, attachments, subpass, dependencies);
}

}  // namespace honeycomb::Viewer
