#include "apps/viewer/bindings.h"

#include <array>

#include "apps/viewer/scene_block.h"

namespace honeycomb::Viewer {
namespace {

Owned<VkDescriptorPool> makeDescriptorPool(Maker& make, const Gpu& gpu) {
  const std::array<VkDescriptorPoolSize, 3> sizes{{{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1},
                                                   {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1},
                                                   {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 2 * kPointBuffers}}};
  auto info = structure<VkDescriptorPoolCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO);
  info.maxSets = 3;
  info.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
  info.pPoolSizes = sizes.data();
  return make.own(gpu.call.vkCreateDescriptorPool, gpu.call.vkDestroyDescriptorPool, info, "create a descriptor pool");
}

VkDescriptorSet allocateSet(Maker& make, const Gpu& gpu, VkDescriptorPool pool, VkDescriptorSetLayout layout) {
  auto info = structure<VkDescriptorSetAllocateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO);
  info.descriptorPool = pool;
  info.descriptorSetCount = 1;
  info.pSetLayouts = &layout;
  VkDescriptorSet set = VK_NULL_HANDLE;
  if (make.ok()) make.check(gpu.call.vkAllocateDescriptorSets(gpu.device.device, &info, &set), "allocate descriptors");
  return set;
}

VkWriteDescriptorSet writeOf(VkDescriptorSet set, std::uint32_t binding, VkDescriptorType type) {
  auto write = structure<VkWriteDescriptorSet>(VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET);
  write.dstSet = set;
  write.dstBinding = binding;
  write.descriptorCount = 1;
  write.descriptorType = type;
  return write;
}

VkDeviceSize bytesOf(const PointSource& points, std::int32_t count) {
  return static_cast<VkDeviceSize>(points.byteExtent(count));
}

void writeSet(const Gpu& gpu, VkDescriptorSet set, const std::array<VkDescriptorBufferInfo, kPointBuffers>& infos) {
  std::array<VkWriteDescriptorSet, kPointBuffers> writes{};
  for (std::uint32_t i = 0; i < kPointBuffers; ++i) {
    writes[i] = writeOf(set, i, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER);
    writes[i].pBufferInfo = &infos[i];
  }
  gpu.call.vkUpdateDescriptorSets(gpu.device.device, kPointBuffers, writes.data(), 0, nullptr);
}

}  // namespace

Bindings makeBindings(Maker& make, const Gpu& gpu, const Pipelines& pipelines) {
  Bindings made;
  made.pool = makeDescriptorPool(make, gpu);
  made.scene = allocateSet(make, gpu, made.pool.get(), pipelines.sceneSet.get());
  made.points = allocateSet(make, gpu, made.pool.get(), pipelines.pointSet.get());
  made.lines = allocateSet(make, gpu, made.pool.get(), pipelines.pointSet.get());
  return made;
}

void bindScene(const Gpu& gpu, const Bindings& bindings, const Buffer& scene, const Targets& targets) {
  const VkDescriptorBufferInfo block{scene.get(), 0, sizeof(SceneBlock)};
  const VkDescriptorImageInfo maps{targets.shadowSampler.get(), targets.shadowMaps.view.get(),
                                   VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL};
  std::array writes{writeOf(bindings.scene, 0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER),
                    writeOf(bindings.scene, 1, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER)};
  writes[0].pBufferInfo = &block;
  writes[1].pImageInfo = &maps;
  gpu.call.vkUpdateDescriptorSets(gpu.device.device, static_cast<std::uint32_t>(writes.size()), writes.data(), 0,
                                  nullptr);
}

void bindPoints(const Gpu& gpu, const Bindings& bindings, const CellMesh& mesh, const PointSource& positions,
                const PointSource& normals) {
  writeSet(gpu, bindings.points,
           {{{positions.buffer, 0, bytesOf(positions, mesh.vertexCount)},
             {normals.buffer, 0, bytesOf(normals, mesh.vertexCount)},
             {mesh.faceOffsets.get(), 0, VK_WHOLE_SIZE},
             {mesh.corners.get(), 0, VK_WHOLE_SIZE},
             {mesh.faceColours.get(), 0, VK_WHOLE_SIZE}}});
}

void bindLines(const Gpu& gpu, const Bindings& bindings, const LineMesh& lines, const PointSource& positions) {
  // Lines between points read neither normals, offsets nor colours; a set has them all the same.
  const VkDescriptorBufferInfo points{positions.buffer, 0, bytesOf(positions, lines.vertexCount)};
  const VkDescriptorBufferInfo pairs{lines.pairs.get(), 0, VK_WHOLE_SIZE};
  writeSet(gpu, bindings.lines, {{points, points, pairs, pairs, pairs}});
}

}  // namespace honeycomb::Viewer
