#include "apps/cli/info_machine.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "apps/cli/chain.h"
#include "apps/cli/console.h"
#include "apps/cli/devices.h"
#include "apps/cli/json_text.h"
#include "apps/cli/memory.h"
#include "apps/cli/surface_evaluator.h"
#include "far/base/parallel.h"

namespace honeycomb::Cli {
namespace {

using Json = nlohmann::ordered_json;

void addDevice(std::string& text, const VulkanDeviceInfo& device) {
  fmt::format_to(std::back_inserter(text), "  {:<12} {} ({}), Vulkan {}\n", "Vulkan", device.name, device.type,
                 device.version);
  fmt::format_to(std::back_inserter(text),
                 "  {:<12} memory {}, storage buffer {}, workgroup {} invocations, {} shared\n", "",
                 humanBytes(device.memory), humanBytes(device.storageBufferRange), grouped(device.workgroupInvocations),
                 humanBytes(device.sharedMemory));
}

Json deviceJson(const VulkanDeviceInfo& device) {
  return {{"name", device.name},
          {"type", device.type},
          {"vulkan", device.version},
          {"memory_bytes", device.memory},
          {"storage_buffer_bytes", device.storageBufferRange},
          {"workgroup_invocations", device.workgroupInvocations},
          {"subgroup_size", device.subgroupSize},
          {"shared_memory_bytes", device.sharedMemory}};
}

}  // namespace

std::string processorName() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown processor";
}

std::string machineText() {
  std::string text = "honeycomb " HONEYCOMB_VERSION "\n";
  const auto row = [&text](std::string_view name, const std::string& value) {
    fmt::format_to(std::back_inserter(text), "  {:<12} {}\n", name, value);
  };
  row("processor", fmt::format("{}, {}", processorName(), counted(Parallel::threadCount(), "thread")));
  row("memory", humanBytes(availableMemory()) + " free for a run");
  const Result<std::vector<VulkanDeviceInfo>> devices = vulkanDevices();
  if (!devices) row("Vulkan", devices.error().message);
  if (devices && devices->empty()) row("Vulkan", "no device; install a driver, such as mesa-vulkan-drivers");
  if (devices)
    for (const VulkanDeviceInfo& device : *devices) addDevice(text, device);
  row("backends", names(backends()));
  row("schemes", names(schemes()));
  row("limits", fmt::format("{} half-edges a level, {} levels", grouped(kMostHalfEdges), Far::kMaxLevels));
  return text;
}

std::string machineJson() {
  Json devices = Json::array();
  const Result<std::vector<VulkanDeviceInfo>> found = vulkanDevices();
  if (found)
    for (const VulkanDeviceInfo& device : *found) devices.push_back(deviceJson(device));
  Json backendNames = Json::array(), schemeNames = Json::array();
  for (const BackendEntry& backend : backends()) backendNames.push_back(backend.name);
  for (const SchemeEntry& scheme : schemes()) schemeNames.push_back(scheme.name);
  return jsonText({{"version", HONEYCOMB_VERSION},
                   {"processor", processorName()},
                   {"threads", Parallel::threadCount()},
                   {"memory_bytes", availableMemory()},
                   {"vulkan_devices", devices},
                   {"vulkan_error", found ? Json() : Json(found.error().message)},
                   {"backends", backendNames},
                   {"schemes", schemeNames},
                   {"limits", {{"half_edges", kMostHalfEdges}, {"levels", Far::kMaxLevels}}}});
}

}  // namespace honeycomb::Cli
