#include "apps/viewer/renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "apps/viewer/recording.h"
#include "apps/viewer/scene_block.h"

namespace honeycomb::Viewer {

struct Renderer::State {
  Gpu gpu;
  VkExtent2D extent{};
  Pipelines pipelines;
  Targets targets;
  Buffer scene;
  Bindings bindings;
  Owned<VkCommandPool> pool;
  VkCommandBuffer commands = VK_NULL_HANDLE;
  Owned<VkFence> done;
};

namespace {

Result<void> checkSize(const Gpu& gpu, const RendererOptions& options) {
  const auto limit = static_cast<std::int64_t>(
      std::min({gpu.limits.maxImageDimension2D, gpu.limits.maxFramebufferWidth, gpu.limits.maxFramebufferHeight}));
  if (options.width >= 1 && options.height >= 1 && options.width <= limit && options.height <= limit) return {};
  return fail(ErrorCode::invalidOption, fmt::format("a picture of {} x {} pixels can't be drawn; each side must be "
                                                    "between 1 and {}",
                                                    options.width, options.height, limit));
}

Result<void> checkPoints(const Gpu& gpu, const PointSource& points, std::int32_t count, const char* what) {
  if (points.offset < 0 || points.stride < 3) {
    return fail(ErrorCode::invalidOption,
                fmt::format("the {} to draw have offset {} and stride {}; they must be at least 0 and 3", what,
                            points.offset, points.stride));
  }
  const std::int64_t bytes = points.byteExtent(count);
  if (bytes <= static_cast<std::int64_t>(gpu.limits.maxStorageBufferRange)) return {};
  return fail(ErrorCode::tooLarge, fmt::format("the {} to draw take {} bytes and the device binds {} at most; draw a "
                                               "lower level",
                                               what, bytes, gpu.limits.maxStorageBufferRange));
}

VkCommandBuffer allocateCommandBuffer(Maker& make, const Gpu& gpu, VkCommandPool pool) {
  auto info = structure<VkCommandBufferAllocateInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO);
  info.commandPool = pool;
  info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  info.commandBufferCount = 1;
  VkCommandBuffer buffer = VK_NULL_HANDLE;
  if (make.ok()) {
    make.check(gpu.call.vkAllocateCommandBuffers(gpu.device.device, &info, &buffer), "allocate a command buffer");
  }
  return buffer;
}

PointPush pushOf(const CellMesh& mesh, const PointSource& positions, const PointSource& normals) {
  PointPush push;
  push.vertexCount = static_cast<std::uint32_t>(mesh.vertexCount);
  push.positionOffset = static_cast<std::uint32_t>(positions.offset);
  push.positionStride = static_cast<std::uint32_t>(positions.stride);
  push.normalOffset = static_cast<std::uint32_t>(normals.offset);
  push.normalStride = static_cast<std::uint32_t>(normals.stride);
  return push;
}

/// Submits the recorded commands and waits for them.
void submit(Maker& make, const Gpu& gpu, VkCommandBuffer commands, VkFence done) {
  auto info = structure<VkSubmitInfo>(VK_STRUCTURE_TYPE_SUBMIT_INFO);
  info.commandBufferCount = 1;
  info.pCommandBuffers = &commands;
  make.check(gpu.call.vkResetFences(gpu.device.device, 1, &done), "reset a fence");
  if (make.ok()) make.check(gpu.call.vkQueueSubmit(gpu.device.queue, 1, &info, done), "submit a picture");
  constexpr auto kForever = std::numeric_limits<std::uint64_t>::max();
  if (make.ok()) {
    make.check(gpu.call.vkWaitForFences(gpu.device.device, 1, &done, VK_TRUE, kForever), "finish a picture");
  }
}

}  // namespace

Renderer::Renderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

Result<Renderer> Renderer::create(const Osd::VulkanDevice& device, const RendererOptions& options) {
  auto state = std::make_unique<State>();
  State& s = *state;
  auto gpu = openGpu(device);
  if (!gpu) return tl::unexpected(gpu.error());
  s.gpu = *gpu;
  if (auto sized = checkSize(s.gpu, options); !sized) return tl::unexpected(sized.error());
  s.extent = {static_cast<std::uint32_t>(options.width), static_cast<std::uint32_t>(options.height)};
  Maker make(s.gpu);
  const VkFormat depthFormat = pickDepthFormat(s.gpu);
  s.pipelines = makePipelines(make, s.gpu, depthFormat);
  s.targets = makeTargets(make, s.gpu, s.pipelines, depthFormat, s.extent);
  s.scene = make.buffer(sizeof(SceneBlock), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, Residence::device);
  s.bindings = makeBindings(make, s.gpu, s.pipelines);
  auto pool = structure<VkCommandPoolCreateInfo>(VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO);
  pool.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
  pool.queueFamilyIndex = device.queueFamily;
  s.pool = make.own(s.gpu.call.vkCreateCommandPool, s.gpu.call.vkDestroyCommandPool, pool, "create a command pool");
  s.commands = allocateCommandBuffer(make, s.gpu, s.pool.get());
  const auto fence = structure<VkFenceCreateInfo>(VK_STRUCTURE_TYPE_FENCE_CREATE_INFO);
  s.done = make.own(s.gpu.call.vkCreateFence, s.gpu.call.vkDestroyFence, fence, "create a fence");
  if (!make.ok()) return tl::unexpected(*make.error());
  bindScene(s.gpu, s.bindings, s.scene, s.targets);
  return Renderer(std::move(state));
}

Result<CellMesh> Renderer::upload(const CellMeshContent& content) const {
  return uploadCells(state_->gpu, content);
}

Result<Buffer> Renderer::uploadPoints(std::span<const float> points) const {
  Maker make(state_->gpu);
  Buffer buffer = make.buffer(std::as_bytes(points), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  if (!make.ok()) return tl::unexpected(*make.error());
  return buffer;
}

Result<Picture> Renderer::draw(const CellMesh& mesh, const PointSource& positions, const PointSource& normals,
                               const View& view) {
  State& s = *state_;
  if (auto fits = checkPoints(s.gpu, positions, mesh.vertexCount, "positions"); !fits) {
    return tl::unexpected(fits.error());
  }
  if (auto fits = checkPoints(s.gpu, normals, mesh.vertexCount, "normals"); !fits) return tl::unexpected(fits.error());
  const SceneBlock scene = arrangeScene(view.camera, view.bounds, view.style, {s.extent.width, s.extent.height});
  std::memcpy(s.scene.mapped, &scene, sizeof scene);
  bindPoints(s.gpu, s.bindings, mesh, positions, normals);
  Maker make(s.gpu);
  auto begin = structure<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  make.check(s.gpu.call.vkBeginCommandBuffer(s.commands, &begin), "begin a command buffer");
  if (make.ok()) {
    const Shot shot{s.pipelines, s.targets, s.bindings, mesh, pushOf(mesh, positions, normals), s.extent};
    recordPicture(s.gpu, s.commands, shot);
    make.check(s.gpu.call.vkEndCommandBuffer(s.commands), "end a command buffer");
  }
  if (make.ok()) submit(make, s.gpu, s.commands, s.done.get());
  if (!make.ok()) return tl::unexpected(*make.error());
  Picture picture{static_cast<std::int32_t>(s.extent.width), static_cast<std::int32_t>(s.extent.height), {}};
  picture.rgba.resize(s.targets.pixels.size);
  std::memcpy(picture.rgba.data(), s.targets.pixels.mapped, picture.rgba.size());
  return picture;
}

}  // namespace honeycomb::Viewer
