#include "apps/viewer/pipelines.h"

#include <array>

#include "apps/viewer/passes.h"
#include "apps/viewer/shader_code.h"

namespace honeycomb::Viewer {
namespace {

Owned<VkDescriptorSetLayout> makeSetLayout(Maker& make, const Gpu& gpu,
                                           std::span<const VkDescriptorSetLayoutBinding> bindings) {
  auto info = structure<VkDescriptorSetLayoutCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO);
  info.bindingCount = static_cast<std::uint32_t>(bindings.size());
  info.pBindings = bindings.data();
  return make.own(gpu.call.vkCreateDescriptorSetLayout, gpu.call.vkDestroyDescriptorSetLayout, info,
                  "create a descriptor set layout");
}

Owned<VkDescriptorSetLayout> makeSceneSet(Maker& make, const Gpu& gpu) {
  const VkShaderStageFlags both = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;
  const std::array<VkDescriptorSetLayoutBinding, 2> bindings{
      {{0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1, both, nullptr},
       {1, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1, VK_SHADER_STAGE_FRAGMENT_BIT, nullptr}}};
  return makeSetLayout(make, gpu, bindings);
}

Owned<VkDescriptorSetLayout> makePointSet(Maker& make, const Gpu& gpu) {
  std::array<VkDescriptorSetLayoutBinding, kPointBuffers> bindings{};
  for (std::uint32_t i = 0; i < kPointBuffers; ++i) {
    bindings[i] = {i, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_VERTEX_BIT, nullptr};
  }
  return makeSetLayout(make, gpu, bindings);
}

Owned<VkPipelineLayout> makeLayout(Maker& make, const Gpu& gpu, const Pipelines& pipelines) {
  const std::array sets{pipelines.sceneSet.get(), pipelines.pointSet.get()};
  const VkPushConstantRange push{kPushStages, 0, sizeof(PointPush)};
  auto info = structure<VkPipelineLayoutCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO);
  info.setLayoutCount = static_cast<std::uint32_t>(sets.size());
  info.pSetLayouts = sets.data();
  info.pushConstantRangeCount = 1;
  info.pPushConstantRanges = &push;
  return make.own(gpu.call.vkCreatePipelineLayout, gpu.call.vkDestroyPipelineLayout, info, "create a pipeline layout");
}

Owned<VkShaderModule> makeModule(Maker& make, const Gpu& gpu, std::span<const std::uint32_t> code) {
  auto info = structure<VkShaderModuleCreateInfo>(VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO);
  info.codeSize = code.size_bytes();
  info.pCode = code.data();
  return make.own(gpu.call.vkCreateShaderModule, gpu.call.vkDestroyShaderModule, info, "load a shader");
}

/// In what our pipelines differ.
struct PipelineChoice {
  std::span<const std::uint32_t> vertexCode;
  std::span<const std::uint32_t> fragmentCode;  ///< empty: depth only
  VkRenderPass pass = VK_NULL_HANDLE;
  VkSampleCountFlagBits samples = kSamples;
  VkCompareOp depth = VK_COMPARE_OP_LESS;
  bool writesDepth = true;
  float slopeBias = 0;
  bool blended = false;
};

VkPipelineShaderStageCreateInfo stage(VkShaderStageFlagBits which, VkShaderModule module) {
  auto info = structure<VkPipelineShaderStageCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO);
  info.stage = which;
  info.module = module;
  info.pName = "main";
  return info;
}

VkPipelineRasterizationStateCreateInfo rasterization(const PipelineChoice& choice) {
  auto raster =
      structure<VkPipelineRasterizationStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO);
  raster.frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE;
  raster.lineWidth = 1;
  raster.depthBiasEnable = choice.slopeBias > 0 ? VK_TRUE : VK_FALSE;
  raster.depthBiasConstantFactor = 1;
  raster.depthBiasSlopeFactor = choice.slopeBias;
  return raster;
}

VkPipelineDepthStencilStateCreateInfo depthState(const PipelineChoice& choice) {
  auto depth =
      structure<VkPipelineDepthStencilStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO);
  depth.depthTestEnable = VK_TRUE;
  depth.depthWriteEnable = choice.writesDepth ? VK_TRUE : VK_FALSE;
  depth.depthCompareOp = choice.depth;
  return depth;
}

VkPipelineColorBlendAttachmentState blending(const PipelineChoice& choice) {
  VkPipelineColorBlendAttachmentState state{};
  state.blendEnable = choice.blended ? VK_TRUE : VK_FALSE;
  state.srcColorBlendFactor = VK_BLEND_FACTOR_SRC_ALPHA;
  state.dstColorBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
  state.srcAlphaBlendFactor = VK_BLEND_FACTOR_ZERO;
  state.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
  state.colorWriteMask = 0xf;
  return state;
}

/// The states of a pipeline that point at one another; stays where it was made.
struct FixedState {
  // Points are pulled from storage buffers by index; no vertex input.
  VkPipelineVertexInputStateCreateInfo input =
      structure<VkPipelineVertexInputStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO);
  VkPipelineInputAssemblyStateCreateInfo assembly =
      structure<VkPipelineInputAssemblyStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO);
  VkPipelineViewportStateCreateInfo viewport =
      structure<VkPipelineViewportStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO);
  VkPipelineRasterizationStateCreateInfo raster;
  VkPipelineMultisampleStateCreateInfo multisample =
      structure<VkPipelineMultisampleStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO);
  VkPipelineDepthStencilStateCreateInfo depth;
  VkPipelineColorBlendAttachmentState colours;
  VkPipelineColorBlendStateCreateInfo blend =
      structure<VkPipelineColorBlendStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO);
  std::array<VkDynamicState, 2> dynamicStates{VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
  VkPipelineDynamicStateCreateInfo dynamic =
      structure<VkPipelineDynamicStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO);

  explicit FixedState(const PipelineChoice& choice)
      : raster(rasterization(choice)), depth(depthState(choice)), colours(blending(choice)) {
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    viewport.viewportCount = 1;
    viewport.scissorCount = 1;
    multisample.rasterizationSamples = choice.samples;
    blend.attachmentCount = choice.fragmentCode.empty() ? 0 : 1;
    blend.pAttachments = &colours;
    dynamic.dynamicStateCount = static_cast<std::uint32_t>(dynamicStates.size());
    dynamic.pDynamicStates = dynamicStates.data();
  }
  FixedState(const FixedState&) = delete;
  FixedState& operator=(const FixedState&) = delete;
};

Owned<VkPipeline> makePipeline(Maker& make, const Gpu& gpu, VkPipelineLayout layout, const PipelineChoice& choice) {
  const Owned<VkShaderModule> vertex = makeModule(make, gpu, choice.vertexCode);
  Owned<VkShaderModule> fragment;
  if (!choice.fragmentCode.empty()) fragment = makeModule(make, gpu, choice.fragmentCode);
  if (!make.ok()) return {};
  const std::array stages{stage(VK_SHADER_STAGE_VERTEX_BIT, vertex.get()),
                          stage(VK_SHADER_STAGE_FRAGMENT_BIT, fragment.get())};
  const FixedState state(choice);
  auto info = structure<VkGraphicsPipelineCreateInfo>(VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO);
  info.stageCount = choice.fragmentCode.empty() ? 1 : 2;
  info.pStages = stages.data();
  info.pVertexInputState = &state.input;
  info.pInputAssemblyState = &state.assembly;
  info.pViewportState = &state.viewport;
  info.pRasterizationState = &state.raster;
  info.pMultisampleState = &state.multisample;
  info.pDepthStencilState = &state.depth;
  info.pColorBlendState = &state.blend;
  info.pDynamicState = &state.dynamic;
  info.layout = layout;
  info.renderPass = choice.pass;
  VkPipeline pipeline = VK_NULL_HANDLE;
  make.check(
      gpu.call.vkCreateGraphicsPipelines(gpu.device.device, VK_NULL_HANDLE, 1, &info, gpu.device.allocator, &pipeline),
      "create a graphics pipeline");
  return {gpu.device.device, pipeline, gpu.call.vkDestroyPipeline, gpu.device.allocator};
}

}  // namespace

Pipelines makePipelines(Maker& make, const Gpu& gpu, const PictureFormats& formats) {
  Pipelines made;
  made.sceneSet = makeSceneSet(make, gpu);
  made.pointSet = makePointSet(make, gpu);
  made.layout = makeLayout(make, gpu, made);
  made.shadowPass = makeShadowPass(make, gpu);
  made.picturePass = makePicturePass(make, gpu, formats);
  const auto pipeline = [&](const PipelineChoice& choice) {
    return makePipeline(make, gpu, made.layout.get(), choice);
  };
  // The bias keeps a surface out of its own shadow at the slopes where a texel spans much depth.
  made.shadow = pipeline({.vertexCode = ShaderCode::shadowVertex(),
                          .fragmentCode = {},
                          .pass = made.shadowPass.get(),
                          .samples = VK_SAMPLE_COUNT_1_BIT,
                          .slopeBias = 1.5f});
  const PipelineChoice cells{ShaderCode::cellsVertex(), ShaderCode::cellsFragment(), made.picturePass.get()};
  made.cells = pipeline(cells);
  PipelineChoice backdrop{ShaderCode::backdropVertex(), ShaderCode::backdropFragment(), made.picturePass.get()};
  backdrop.depth = VK_COMPARE_OP_ALWAYS;
  backdrop.writesDepth = false;
  made.backdrop = pipeline(backdrop);
  PipelineChoice lines{ShaderCode::linesVertex(), ShaderCode::linesFragment(), made.picturePass.get()};
  lines.writesDepth = false;
  lines.blended = true;
  made.lines = pipeline(lines);
  lines.depth = VK_COMPARE_OP_GREATER;
  made.hiddenLines = pipeline(lines);
  return made;
}

}  // namespace honeycomb::Viewer
