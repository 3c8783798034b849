#include <fmt/format.h>

#include <algorithm>

#include "apps/cli/devices.h"
#include "apps/cli/frame_tiles.h"
#include "apps/cli/surface_evaluator.h"
#include "far/base/index.h"
#include "far/tables/tile_table.h"
#include "io/cache_folder.h"
#include "osd/vulkan/context.h"
#include "osd/vulkan/frames.h"

namespace honeycomb::Cli {
namespace {

/// Frames of a bake on their way: one is written to the device's memory, one computed, one read.
constexpr int kFramesInFlight = 3;

/// Frame after frame on the device, with tables uploaded once.
class VulkanSurfaceEvaluator : public SurfaceEvaluator, public FrameStream {
 public:
  VulkanSurfaceEvaluator(Osd::VulkanFrames frames, std::int32_t vertexCount)
      : frames_(std::move(frames)), vertexCount_(vertexCount) {}

  int depth() const override { return static_cast<int>(frames_.framesInFlight()); }
  Result<void> submit(std::span<const float> control) override {
    const auto ticket = frames_.submit(control);
    if (!ticket) return tl::unexpected(ticket.error());
    newest_ = *ticket;
    ++onTheirWay_;
    return {};
  }
  Result<void> collect(Surface<float>& surface) override {
    const Osd::VulkanTicket oldest{newest_.semaphore, newest_.value + 1 - onTheirWay_};
    --onTheirWay_;
    if (auto done = frames_.wait(oldest); !done) return done;
    const auto results = frames_.results(oldest);
    if (!results) return tl::unexpected(results.error());
    surface.vertexCount = vertexCount_;
    const auto points = (*results)->numbers(Osd::PointBuffer::refined);
    const auto normals = (*results)->numbers(Osd::PointBuffer::vertexNormals);
    surface.points.assign(points.begin(), points.end());
    // Fast ones come for all points, those behind the vertices included.
    const std::size_t numbers = std::min(normals.size(), 3 * at(vertexCount_));
    surface.normals.assign(normals.begin(), normals.begin() + static_cast<std::ptrdiff_t>(numbers));
    return {};
  }

  Result<void> evaluate(std::span<const float> control, Surface<float>& surface) override {
    if (auto sent = submit(control); !sent) return sent;
    return collect(surface);
  }
  Result<void> evaluate(std::span<const double>, Surface<double>&) override {
    return fail(ErrorCode::unsupported, "the vulkan backend has single precision only; use --backend serial or tbb");
  }

 private:
  Osd::VulkanFrames frames_;
  std::int32_t vertexCount_;
  Osd::VulkanTicket newest_;
  std::uint64_t onTheirWay_ = 0;
};

class VulkanBackend : public Backend {
 public:
  VulkanBackend(Osd::VulkanContext context, Osd::VulkanEvaluator evaluator)
      : context_(std::move(context)), evaluator_(std::move(evaluator)) {}

  std::string_view name() const override { return "vulkan"; }
  Result<std::unique_ptr<SurfaceEvaluator>> evaluator(const Far::Refinement& refinement, Normals normals) override {
    Osd::VulkanTableOptions options;
    if (normals != Normals::none) options.vertexLimits.normals = Osd::BufferDescriptor{};
    if (normals == Normals::fast) options.normalKind = Far::TileNormalKind::fast;
    const auto table = evaluator_.upload(refinement, options);
    if (!table) return tl::unexpected(table.error());
    return inFlight(refinement, *table, 1);
  }
  int framesAtOnce() const override { return kFramesInFlight; }
  Result<FrameEvaluators> frameEvaluators(const SurfaceTables& tables, std::int32_t frames, int atOnce) override {
    const bool onCpu = evaluator_.core()->type == VK_PHYSICAL_DEVICE_TYPE_CPU;
    const bool build = tables.refinement != nullptr && deviceTilesPay(onCpu, tables.levels, frames, atOnce);
    if (tables.tiles != nullptr || build) {
      const auto tiles = uploadTiles(tables);
      if (tiles) return streamOf(tables, *tiles, atOnce, static_cast<std::int64_t>(tiles->byteCount()));
      // Level after level works under none of the limits that tiles have.
      if (tiles.error().code != ErrorCode::tooLarge) return tl::unexpected(tiles.error());
    }
    const auto levels = evaluator_.upload(tables.levels);
    if (!levels) return tl::unexpected(levels.error());
    return streamOf(tables, *levels, atOnce, 0);
  }

 private:
  Result<Osd::VulkanTable> uploadTiles(const SurfaceTables& tables) {
    if (tables.tiles != nullptr) return evaluator_.uploadTiles(tables.levels, *tables.tiles);
    const Result<Far::TileTable> tiles = Far::buildTileTable(*tables.refinement, evaluator_.tileOptions());
    if (!tiles) return tl::unexpected(tiles.error());
    return evaluator_.uploadTiles(tables.levels, *tiles);
  }
  Result<FrameEvaluators> streamOf(const SurfaceTables& tables, const Osd::VulkanTable& table, int atOnce,
                                   std::int64_t tileBytes) {
    auto made = inFlight(tables, table, atOnce);
    if (!made) return tl::unexpected(made.error());
    FrameEvaluators evaluators;
    evaluators.tileBytes = tileBytes;
    evaluators.stream = made->get();
    evaluators.each.push_back(std::move(*made));
    return evaluators;
  }
  Result<std::unique_ptr<VulkanSurfaceEvaluator>> inFlight(const SurfaceTables& tables, const Osd::VulkanTable& table,
                                                           int count) {
    auto frames = Osd::VulkanFrames::create(evaluator_, table, {.framesInFlight = static_cast<std::uint32_t>(count)});
    if (!frames) return tl::unexpected(frames.error());
    return std::make_unique<VulkanSurfaceEvaluator>(std::move(*frames), tables.vertexCount);
  }

  Osd::VulkanContext context_;
  Osd::VulkanEvaluator evaluator_;
};

/// The option that asked for the device, and what works without.
Error unusable(Error error) {
  error.message = fmt::format("--backend vulkan: {} (--backend tbb needs no device)", error.message);
  return error;
}

std::string versionText(std::uint32_t version) {
  return fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version),
                     VK_API_VERSION_PATCH(version));
}

}  // namespace

Result<std::unique_ptr<Backend>> openVulkan() {
  Result<Osd::VulkanContext> context = Osd::VulkanContext::create();
  if (!context) return tl::unexpected(unusable(context.error()));
  const Osd::VulkanEvaluatorOptions options{.pipelineCache =
                                                Osd::pipelineCacheIn(Io::cacheFolder(), context->deviceName())};
  Result<Osd::VulkanEvaluator> evaluator = Osd::VulkanEvaluator::create(context->device(), options);
  if (!evaluator) return tl::unexpected(unusable(evaluator.error()));
  return std::make_unique<VulkanBackend>(std::move(*context), std::move(*evaluator));
}

Result<std::vector<VulkanDeviceInfo>> vulkanDevices() {
  const Result<std::vector<Osd::DeviceInfo>> devices = Osd::listDevices();
  if (!devices) return tl::unexpected(devices.error());
  std::vector<VulkanDeviceInfo> infos;
  for (const Osd::DeviceInfo& device : *devices)
    infos.push_back({device.name, Osd::deviceTypeName(device.type), versionText(device.apiVersion),
                     static_cast<std::int64_t>(device.heapSize),
                     static_cast<std::int64_t>(device.maxStorageBufferRange), device.maxWorkgroupInvocations,
                     device.subgroupSize, device.sharedMemorySize});
  return infos;
}

}  // namespace honeycomb::Cli
