#pragma once

#include <glm/glm.hpp>

#include "apps/viewer/gpu.h"

namespace honeycomb::Viewer {

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
  // Of lines alone.
  std::uint32_t spikes = 0;  ///< 1: from each point along its normal; 0: between the points of each pair
  float reach = 0;           ///< length of a spike, world units
  float halfWidth = 1;       ///< pixels
  float padding[3] = {};
  glm::vec4 colour{0};  ///< linear rgb; w: opacity
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
  Owned<VkPipeline> lines;        ///< in front of the cells
  Owned<VkPipeline> hiddenLines;  ///< behind them
};
constexpr std::uint32_t kPointBuffers = 5;
constexpr VkShaderStageFlags kPushStages = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;

/// What pictures are made of: 8-bit sRGB in either order of red and blue, and depth.
struct PictureFormats {
  VkFormat colour = VK_FORMAT_R8G8B8A8_SRGB;
  VkFormat depth = VK_FORMAT_UNDEFINED;
};

Pipelines makePipelines(Maker& make, const Gpu& gpu, const PictureFormats& formats);

}  // namespace honeycomb::Viewer
