#pragma once

#include "apps/viewer/gpu.h"

namespace honeycomb::Viewer {

constexpr VkFormat kColourFormat = VK_FORMAT_R8G8B8A8_SRGB;
/// Every Vulkan device can draw into and sample this depth format, and take four samples of colour and depth.
constexpr VkFormat kShadowFormat = VK_FORMAT_D16_UNORM;
constexpr VkSampleCountFlagBits kSamples = VK_SAMPLE_COUNT_4_BIT;

/// The push constants of shaders/points.glsl; offsets and strides in floats.
struct PointPush {
  std::uint32_t vertexCount = 0;
  std::uint32_t positionOffset = 0;
  std::uint32_t positionStride = 3;
  std::uint32_t normalOffset = 0;
  std::uint32_t normalStride = 3;
  std::uint32_t light = 0;
};

/// What is fixed for the renderer's life: descriptor layouts, passes and pipelines.
///     set 0: 0 scene block, 1 shadow maps        set 1: positions, normals, face offsets, corners, face colours
struct Pipelines {
  Owned<VkDescriptorSetLayout> sceneSet;
  Owned<VkDescriptorSetLayout> pointSet;
  Owned<VkPipelineLayout> layout;
  Owned<VkRenderPass> shadowPass;
  Owned<VkRenderPass> picturePass;  ///< attachments: colour, depth (both kSamples), resolved colour
  Owned<VkPipeline> shadow;
  Owned<VkPipeline> backdrop;
  Owned<VkPipeline> cells;
};
constexpr std::uint32_t kPointBuffers = 5;

Pipelines makePipelines(Maker& make, const Gpu& gpu, VkFormat depthFormat);

}  // namespace honeycomb::Viewer
