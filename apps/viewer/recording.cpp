#include "apps/viewer/recording.h"

#include <array>

#include "apps/viewer/scene_block.h"

namespace honeycomb::Viewer {
namespace {

void setArea(const Gpu& gpu, VkCommandBuffer cb, std::uint32_t x, std::uint32_t y, VkExtent2D size) {
  const VkViewport viewport{static_cast<float>(x),
                            static_cast<float>(y),
                            static_cast<float>(size.width),
                            static_cast<float>(size.height),
                            0,
                            1};
  const VkRect2D scissor{{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)}, size};
  gpu.call.vkCmdSetViewport(cb, 0, 1, &viewport);
  gpu.call.vkCmdSetScissor(cb, 0, 1, &scissor);
}

void beginPass(const Gpu& gpu, VkCommandBuffer cb, VkRenderPass pass, VkFramebuffer frame, VkExtent2D extent,
               std::span<const VkClearValue> clear) {
  auto info = structure<VkRenderPassBeginInfo>(VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO);
  info.renderPass = pass;
  info.framebuffer = frame;
  info.renderArea = {{0, 0}, extent};
  info.clearValueCount = static_cast<std::uint32_t>(clear.size());
  info.pClearValues = clear.data();
  gpu.call.vkCmdBeginRenderPass(cb, &info, VK_SUBPASS_CONTENTS_INLINE);
}

VkClearValue farthest() {
  VkClearValue value{};
  value.depthStencil = {1, 0};
  return value;
}

void bindAll(const Gpu& gpu, VkCommandBuffer cb, const Shot& shot, VkBuffer indices) {
  const std::array sets{shot.bindings.scene, shot.bindings.points};
  gpu.call.vkCmdBindDescriptorSets(cb, VK_PIPELINE_BIND_POINT_GRAPHICS, shot.pipelines.layout.get(), 0,
                                   static_cast<std::uint32_t>(sets.size()), sets.data(), 0, nullptr);
  gpu.call.vkCmdBindIndexBuffer(cb, indices, 0, VK_INDEX_TYPE_UINT32);
}

void push(const Gpu& gpu, VkCommandBuffer cb, const Shot& shot, std::uint32_t light) {
  PointPush values = shot.push;
  values.light = light;
  gpu.call.vkCmdPushConstants(cb, shot.pipelines.layout.get(), kPushStages, 0, sizeof values, &values);
}

/// Points come from a compute shader or a copy earlier on this queue.
void awaitPoints(const Gpu& gpu, VkCommandBuffer cb) {
  auto barrier = structure<VkMemoryBarrier>(VK_STRUCTURE_TYPE_MEMORY_BARRIER);
  barrier.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_SHADER_READ_BIT;
  gpu.call.vkCmdPipelineBarrier(cb, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT,
                                VK_PIPELINE_STAGE_VERTEX_SHADER_BIT, 0, 1, &barrier, 0, nullptr, 0, nullptr);
}

void recordShadows(const Gpu& gpu, VkCommandBuffer cb, const Shot& shot) {
  constexpr std::uint32_t kSide = kTilesAcross * kTileSize;
  const std::array clear{farthest()};
  beginPass(gpu, cb, shot.pipelines.shadowPass.get(), shot.targets.shadowFrame.get(), {kSide, kSide}, clear);
  gpu.call.vkCmdBindPipeline(cb, VK_PIPELINE_BIND_POINT_GRAPHICS, shot.pipelines.shadow.get());
  bindAll(gpu, cb, shot, shot.mesh.solidIndices.get());
  for (std::uint32_t light = 0; light < shot.shadows; ++light) {
    setArea(gpu, cb, light % kTilesAcross * kTileSize, light / kTilesAcross * kTileSize, {kTileSize, kTileSize});
    push(gpu, cb, shot, light);
    gpu.call.vkCmdDrawIndexed(cb, shot.mesh.solidIndexCount, 1, 0, 0, 0);
  }
  gpu.call.vkCmdEndRenderPass(cb);
}

/// How lines look: in front of the cells and, faintly, behind them.
struct Ink {
  glm::vec3 colour;
  float halfWidth;
  float opacity;
  float hidden;
};
const Ink kCageInk{{0.012f, 0.020f, 0.045f}, 0.9f, 0.85f, 0.13f};
const Ink kSpikeInk{{0.02f, 0.09f, 0.30f}, 0.35f, 0.75f, 0.0f};

void recordLines(const Gpu& gpu, VkCommandBuffer cb, const Shot& shot, VkDescriptorSet points, PointPush values,
                 std::uint32_t lines, const Ink& ink) {
  const std::array sets{shot.bindings.scene, points};
  gpu.call.vkCmdBindDescriptorSets(cb, VK_PIPELINE_BIND_POINT_GRAPHICS, shot.pipelines.layout.get(), 0,
                                   static_cast<std::uint32_t>(sets.size()), sets.data(), 0, nullptr);
  values.halfWidth = ink.halfWidth;
  for (const bool hidden : {true, false}) {
    values.colour = glm::vec4(ink.colour, hidden ? ink.hidden : ink.opacity);
    if (values.colour.w <= 0) continue;
    gpu.call.vkCmdBindPipeline(cb, VK_PIPELINE_BIND_POINT_GRAPHICS,
                               (hidden ? shot.pipelines.hiddenLines : shot.pipelines.lines).get());
    gpu.call.vkCmdPushConstants(cb, shot.pipelines.layout.get(), kPushStages, 0, sizeof values, &values);
    gpu.call.vkCmdDraw(cb, 6 * lines, 1, 0, 0);
  }
}

void recordOverlays(const Gpu& gpu, VkCommandBuffer cb, const Shot& shot) {
  if (shot.spikes > 0) {
    PointPush values = shot.push;
    values.spikes = 1;
    values.reach = shot.spikes;
    recordLines(gpu, cb, shot, shot.bindings.points, values, values.vertexCount, kSpikeInk);
  }
  if (shot.cageLines > 0) recordLines(gpu, cb, shot, shot.bindings.lines, shot.cage, shot.cageLines, kCageInk);
}

void recordView(const Gpu& gpu, VkCommandBuffer cb, const Shot& shot) {
  const std::array clear{VkClearValue{}, farthest()};
  beginPass(gpu, cb, shot.pipelines.picturePass.get(), shot.targets.pictureFrame.get(), shot.extent, clear);
  setArea(gpu, cb, 0, 0, shot.extent);
  bindAll(gpu, cb, shot, shot.mesh.cellIndices.get());
  push(gpu, cb, shot, 0);
  gpu.call.vkCmdBindPipeline(cb, VK_PIPELINE_BIND_POINT_GRAPHICS, shot.pipelines.backdrop.get());
  gpu.call.vkCmdDraw(cb, 3, 1, 0, 0);
  gpu.call.vkCmdBindPipeline(cb, VK_PIPELINE_BIND_POINT_GRAPHICS, shot.pipelines.cells.get());
  gpu.call.vkCmdDrawIndexed(cb, shot.mesh.cellIndexCount, 1, 0, 0, 0);
  recordOverlays(gpu, cb, shot);
  gpu.call.vkCmdEndRenderPass(cb);
}

}  // namespace

void recordPicture(const Gpu& gpu, VkCommandBuffer commands, const Shot& shot) {
  awaitPoints(gpu, commands);
  recordShadows(gpu, commands, shot);
  recordView(gpu, commands, shot);
}

void recordReadback(const Gpu& gpu, VkCommandBuffer cb, VkImage image, VkBuffer pixels, VkExtent2D extent) {
  VkBufferImageCopy copy{};
  copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  copy.imageExtent = {extent.width, extent.height, 1};
  gpu.call.vkCmdCopyImageToBuffer(cb, image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, pixels, 1, &copy);
  auto barrier = structure<VkMemoryBarrier>(VK_STRUCTURE_TYPE_MEMORY_BARRIER);
  barrier.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
  gpu.call.vkCmdPipelineBarrier(cb, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &barrier, 0,
                                nullptr, 0, nullptr);
}

}  // namespace honeycomb::Viewer
