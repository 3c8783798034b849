#include <fmt/format.h>

#include <algorithm>

#include "apps/cli/devices.h"
#include "apps/cli/surface_evaluator.h"
#include "osd/vulkan/context.h"
#include "osd/vulkan/session.h"

namespace honeycomb::Cli {
namespace {

/// Frame after frame on the device, with tables uploaded once.
class VulkanSurfaceEvaluator : public SurfaceEvaluator {
 public:
  VulkanSurfaceEvaluator(Osd::VulkanSession session, std::int32_t vertexCount)
      : session_(std::move(session)), vertexCount_(vertexCount) {}

  Result<void> evaluate(std::span<const float> control, Surface<float>& surface) override {
    std::copy(control.begin(), control.end(), session_.control().begin());
    const Result<void> done = session_.run();
    if (!done) return done;
    surface.vertexCount = vertexCount_;
    surface.points.assign(session_.refined().begin(), session_.refined().end());
    surface.normals.assign(session_.vertexNormals().begin(), session_.vertexNormals().end());
    return {};
  }
  Result<void> evaluate(std::span<const double>, Surface<double>&) override {
    return fail(ErrorCode::unsupported, "the vulkan backend has single precision only; use --backend serial or tbb");
  }

 private:
  Osd::VulkanSession session_;
  std::int32_t vertexCount_;
};

class VulkanBackend : public Backend {
 public:
  VulkanBackend(Osd::VulkanContext context, Osd::VulkanEvaluator evaluator)
      : context_(std::move(context)), evaluator_(std::move(evaluator)) {}

  std::string_view name() const override { return "vulkan"; }
  Result<std::unique_ptr<SurfaceEvaluator>> evaluator(const Far::Refinement& refinement, Normals normals) override {
    Osd::VulkanTableOptions options;
    if (normals == Normals::exact) options.vertexLimits.normals = Osd::BufferDescriptor{};
    Result<Osd::VulkanSession> session = Osd::VulkanSession::create(evaluator_, refinement, options);
    if (!session) return tl::unexpected(session.error());
    return std::make_unique<VulkanSurfaceEvaluator>(std::move(*session), refinement.last().topology.vertexCount());
  }
  int framesAtOnce() const override { return 1; }
  Result<FrameEvaluators> frameEvaluators(const Far::Refinement& refinement, std::int32_t, int) override {
    auto only = evaluator(refinement, Normals::none);
    if (!only) return tl::unexpected(only.error());
    FrameEvaluators evaluators;
    evaluators.each.push_back(std::move(*only));
    return evaluators;
  }

 private:
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
  Result<Osd::VulkanEvaluator> evaluator = Osd::VulkanEvaluator::create(context->device());
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
