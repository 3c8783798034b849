#include "apps/viewer/targets.h"

#include <array>

#include "apps/viewer/scene_block.h"

namespace honeycomb::Viewer {
namespace {

Owned<VkFramebuffer> makeFrame(Maker& make, const Gpu& gpu, VkRenderPass pass, std::span<const VkImageView> views,
                               VkExtent2D extent) {
  auto info = structure<VkFramebufferCreateInfo>(VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO);
  info.renderPass = pass;
  info.attachmentCount = static_cast<std::uint32_t>(views.size());
  info.pAttachments = views.data();
  info.width = extent.width;
  info.height = extent.height;
  info.layers = 1;
  return make.own(gpu.call.vkCreateFramebuffer, gpu.call.vkDestroyFramebuffer, info, "create a framebuffer");
}

bool has(const Gpu& gpu, VkFormat format, VkFormatFeatureFlags feature) {
  VkFormatProperties properties;
  gpu.call.vkGetPhysicalDeviceFormatProperties(gpu.device.physicalDevice, format, &properties);
  return (properties.optimalTilingFeatures & feature) == feature;
}

Owned<VkSampler> makeShadowSampler(Maker& make, const Gpu& gpu) {
  const bool smooth = has(gpu, kShadowFormat, VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT);
  auto info = structure<VkSamplerCreateInfo>(VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO);
  info.magFilter = smooth ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
  info.minFilter = info.magFilter;
  info.addressModeU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  info.addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  info.compareEnable = VK_TRUE;
  info.compareOp = VK_COMPARE_OP_LESS_OR_EQUAL;
  return make.own(gpu.call.vkCreateSampler, gpu.call.vkDestroySampler, info, "create a sampler");
}

}  // namespace

VkFormat pickDepthFormat(const Gpu& gpu) {
  for (const VkFormat format : {VK_FORMAT_D32_SFLOAT, VK_FORMAT_X8_D24_UNORM_PACK32}) {
    if (has(gpu, format, VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT)) return format;
  }
  return VK_FORMAT_D16_UNORM;
}

Targets makeTargets(Maker& make, const Gpu& gpu, const Pipelines& pipelines, const PictureFormats& formats,
                    VkExtent2D extent) {
  constexpr std::uint32_t kSide = kTilesAcross * kTileSize;
  constexpr VkImageUsageFlags kDepthUsage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
  Targets made;
  made.shadowMaps = make.image(kShadowFormat, {kSide, kSide}, VK_SAMPLE_COUNT_1_BIT,
                               kDepthUsage | VK_IMAGE_USAGE_SAMPLED_BIT, VK_IMAGE_ASPECT_DEPTH_BIT);
  const std::array shadowViews{made.shadowMaps.view.get()};
  made.shadowFrame = makeFrame(make, gpu, pipelines.shadowPass.get(), shadowViews, {kSide, kSide});
  made.shadowSampler = makeShadowSampler(make, gpu);
  made.colour =
      make.image(formats.colour, extent, kSamples, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT, VK_IMAGE_ASPECT_COLOR_BIT);
  made.depth = make.image(formats.depth, extent, kSamples, kDepthUsage, VK_IMAGE_ASPECT_DEPTH_BIT);
  made.resolved =
      make.image(formats.colour, extent, VK_SAMPLE_COUNT_1_BIT,
                 VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT, VK_IMAGE_ASPECT_COLOR_BIT);
  const std::array views{made.colour.view.get(), made.depth.view.get(), made.resolved.view.get()};
  made.pictureFrame = makeFrame(make, gpu, pipelines.picturePass.get(), views, extent);
  made.pixels = make.buffer(VkDeviceSize{4} * extent.width * extent.height, VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                            Residence::readback);
  return made;
}

}  // namespace honeycomb::Viewer
