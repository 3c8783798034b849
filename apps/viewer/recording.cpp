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
  gpu.call.vkCmdPushConstants(cb, shot.pipelines.layout.get(), VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof values, &values);
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
  for (std::uint32_t light = 0; light < kLights; ++light) {
    setArea(gpu, cb, light % kTilesAcross * kTileSize, light / kTilesAcross * kTileSize, {kTileSize, kTileSize});
    push(gpu, cb, shot, light);
    gpu.call.vkCmdDrawIndexed(cb, shot.mesh.solidIndexCount, 1, 0, 0, 0);
  }
  gpu.call.vkCmdEndRenderPass(cb);
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
  gpu.call.vkCmdEndRenderPass(cb);
}

void recordReadback(const Gpu& gpu, VkCommandBuffer cb, const Shot& shot) {
  VkBufferImageCopy copy{};
  copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  copy.imageExtent = {shot.extent.width, shot.extent.height, 1};
  gpu.call.vkCmdCopyImageToBuffer(cb, shot.targets.resolved.image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                                  shot.targets.pixels.get(), 1, &copy);
  auto barrier = structure<VkMemoryBarrier>(VK_STRUCTURE_TYPE_MEMORY_BARRIER);
  barrier.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
  gpu.call.vkCmdPipelineBarrier(cb, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &barrier, 0,
                                nullptr, 0, nullptr);
}

}  // namespace

void recordPicture(const Gpu& gpu, VkCommandBuffer commands, const Shot& shot) {
  awaitPoints(gpu, commands);
  recordShadows(gpu, commands, shot);
  recordView(gpu, commands, shot);
  recordReadback(gpu, commands, shot);
}

}  // namespace honeycomb::Viewer
