#include "apps/viewer/renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "apps/viewer/recording.h"
#include "apps/viewer/scene_block.h"

namespace honeycomb::Viewer {

struct Renderer::State {
  Gpu gpu;
  PictureFormats formats;
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

constexpr float kSpikeLength = 0.025f;  ///< of a normal that is shown, in radii of the scene

Result<void> checkSize(const Gpu& gpu, std::int32_t width, std::int32_t height) {
  const auto limit = static_cast<std::int64_t>(
      std::min({gpu.limits.maxImageDimension2D, gpu.limits.maxFramebufferWidth, gpu.limits.maxFramebufferHeight}));
  if (width >= 1 && height >= 1 && width <= limit && height <= limit) return {};
  return fail(ErrorCode::invalidOption, fmt::format("a picture of {} x {} pixels can't be drawn; each side must be "
                                                    "between 1 and {}",
                                                    width, height, limit));
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

PointPush pushOf(std::int32_t vertexCount, const PointSource& positions, const PointSource& normals) {
  PointPush push;
  push.vertexCount = static_cast<std::uint32_t>(vertexCount);
  push.positionOffset = static_cast<std::uint32_t>(positions.offset);
  push.positionStride = static_cast<std::uint32_t>(positions.stride);
  push.normalOffset = static_cast<std::uint32_t>(normals.offset);
  push.normalStride = static_cast<std::uint32_t>(normals.stride);
  return push;
}

void swapRedAndBlue(Picture& picture) {
  for (std::size_t i = 0; i + 2 < picture.rgba.size(); i += 4) std::swap(picture.rgba[i], picture.rgba[i + 2]);
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
  if (auto sized = checkSize(s.gpu, options.width, options.height); !sized) return tl::unexpected(sized.error());
  s.formats = {options.colour, pickDepthFormat(s.gpu)};
  s.extent = {static_cast<std::uint32_t>(options.width), static_cast<std::uint32_t>(options.height)};
  Maker make(s.gpu);
  s.pipelines = makePipelines(make, s.gpu, s.formats);
  s.targets = makeTargets(make, s.gpu, s.pipelines, s.formats, s.extent);
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

Result<LineMesh> Renderer::upload(std::int32_t vertexCount, std::span<const std::int32_t> pairs) const {
  return uploadLines(state_->gpu, vertexCount, pairs);
}

void Renderer::recolour(CellMesh& mesh, std::span<const std::uint32_t> faceColours) {
  std::memcpy(mesh.faceColours.mapped, faceColours.data(),
              std::min<std::size_t>(faceColours.size_bytes(), mesh.faceColours.size));
}

VkImage Renderer::image() const {
  return state_->targets.resolved.image.get();
}

VkExtent2D Renderer::extent() const {
  return state_->extent;
}

Result<void> Renderer::resize(std::int32_t width, std::int32_t height) {
  State& s = *state_;
  if (auto sized = checkSize(s.gpu, width, height); !sized) return sized;
  const VkExtent2D extent{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
  Maker make(s.gpu);
  Targets targets = makeTargets(make, s.gpu, s.pipelines, s.formats, extent);
  if (!make.ok()) return tl::unexpected(*make.error());
  s.targets = std::move(targets);
  s.extent = extent;
  bindScene(s.gpu, s.bindings, s.scene, s.targets);
  return {};
}

Result<void> Renderer::record(VkCommandBuffer commands, const Subject& subject, const View& view) {
  State& s = *state_;
  const CellMesh& mesh = subject.mesh;
  if (auto fits = checkPoints(s.gpu, subject.positions, mesh.vertexCount, "positions"); !fits) return fits;
  if (auto fits = checkPoints(s.gpu, subject.normals, mesh.vertexCount, "normals"); !fits) return fits;
  const SceneBlock scene = arrangeScene(view.camera, view.bounds, view.style, {s.extent.width, s.extent.height});
  std::memcpy(s.scene.mapped, &scene, sizeof scene);
  bindPoints(s.gpu, s.bindings, mesh, subject.positions, subject.normals);
  Shot shot{s.pipelines, s.targets, s.bindings, mesh, pushOf(mesh.vertexCount, subject.positions, subject.normals),
            s.extent};
  shot.shadows = shadowCount(view.style.lighting);
  if (subject.spikes) shot.spikes = kSpikeLength * view.bounds.radius();
  if (subject.cage != nullptr) {
    const LineMesh& cage = *subject.cage;
    if (auto fits = checkPoints(s.gpu, subject.cagePoints, cage.vertexCount, "control points"); !fits) return fits;
    bindLines(s.gpu, s.bindings, cage, subject.cagePoints);
    shot.cage = pushOf(cage.vertexCount, subject.cagePoints, subject.cagePoints);
    shot.cageLines = cage.lineCount;
  }
  recordPicture(s.gpu, commands, shot);
  return {};
}

Result<Picture> Renderer::draw(const Subject& subject, const View& view) {
  State& s = *state_;
  Maker make(s.gpu);
  auto begin = structure<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  make.check(s.gpu.call.vkBeginCommandBuffer(s.commands, &begin), "begin a command buffer");
  if (!make.ok()) return tl::unexpected(*make.error());
  const auto recorded = record(s.commands, subject, view);
  if (recorded) recordReadback(s.gpu, s.commands, s.targets.resolved.image.get(), s.targets.pixels.get(), s.extent);
  make.check(s.gpu.call.vkEndCommandBuffer(s.commands), "end a command buffer");
  if (!recorded) return tl::unexpected(recorded.error());
  if (make.ok()) submitAndWait(make, s.gpu, s.commands, s.done.get());
  if (!make.ok()) return tl::unexpected(*make.error());
  Picture picture{static_cast<std::int32_t>(s.extent.width), static_cast<std::int32_t>(s.extent.height), {}};
  picture.rgba.resize(s.targets.pixels.size);
  std::memcpy(picture.rgba.data(), s.targets.pixels.mapped, picture.rgba.size());
  if (s.formats.colour == VK_FORMAT_B8G8R8A8_SRGB) swapRedAndBlue(picture);
  return picture;
}

}  // namespace honeycomb::Viewer
