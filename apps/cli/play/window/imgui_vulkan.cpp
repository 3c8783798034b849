#include "apps/cli/play/window/imgui_vulkan.h"

#include <imgui_impl_vulkan.h>

#include "osd/vulkan/loader.h"

namespace honeycomb::Cli::Play {
namespace {

struct Lookup {
  PFN_vkGetInstanceProcAddr get;
  VkInstance instance;
};

PFN_vkVoidFunction find(const char* name, void* data) {
  const auto* lookup = static_cast<const Lookup*>(data);
  return lookup->get(lookup->instance, name);
}

Result<void> loadFunctions(const Osd::VulkanDevice& device) {
  Lookup lookup{device.getInstanceProcAddr, device.instance};
  if (lookup.get == nullptr) {
    const auto loader = Osd::loadVulkan();
    if (!loader) return tl::unexpected(loader.error());
    lookup.get = *loader;
  }
  if (ImGui_ImplVulkan_LoadFunctions(find, &lookup)) return {};
  return fail(ErrorCode::unsupported, "the Vulkan driver lacks a function that the window needs");
}

Result<void> uploadFonts(const Viewer::Gpu& gpu, VkCommandBuffer commands) {
  Viewer::Maker make(gpu);
  const auto fence = Viewer::structure<VkFenceCreateInfo>(VK_STRUCTURE_TYPE_FENCE_CREATE_INFO);
  const auto done = make.own(gpu.call.vkCreateFence, gpu.call.vkDestroyFence, fence, "create a fence");
  auto begin = Viewer::structure<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  make.check(gpu.call.vkBeginCommandBuffer(commands, &begin), "begin a command buffer");
  if (!make.ok()) return tl::unexpected(*make.error());
  ImGui_ImplVulkan_CreateFontsTexture(commands);
  make.check(gpu.call.vkEndCommandBuffer(commands), "end a command buffer");
  if (make.ok()) Viewer::submitAndWait(make, gpu, commands, done.get());
  if (!make.ok()) return tl::unexpected(*make.error());
  ImGui_ImplVulkan_DestroyFontUploadObjects();
  return {};
}

}  // namespace

Result<std::unique_ptr<ImguiVulkan>> ImguiVulkan::create(const Viewer::Gpu& gpu, VkRenderPass pass,
                                                         VkCommandBuffer commands, std::uint32_t imageCount) {
  if (const auto loaded = loadFunctions(gpu.device); !loaded) return tl::unexpected(loaded.error());
  std::unique_ptr<ImguiVulkan> made(new ImguiVulkan);
  Viewer::Maker make(gpu);
  const VkDescriptorPoolSize fonts{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1};
  auto pool = Viewer::structure<VkDescriptorPoolCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO);
  pool.maxSets = 1;
  pool.poolSizeCount = 1;
  pool.pPoolSizes = &fonts;
  made->pool_ =
      make.own(gpu.call.vkCreateDescriptorPool, gpu.call.vkDestroyDescriptorPool, pool, "create a descriptor pool");
  if (!make.ok()) return tl::unexpected(*make.error());
  ImGui_ImplVulkan_InitInfo info{};
  info.Instance = gpu.device.instance;
  info.PhysicalDevice = gpu.device.physicalDevice;
  info.Device = gpu.device.device;
  info.QueueFamily = gpu.device.queueFamily;
  info.Queue = gpu.device.queue;
  info.DescriptorPool = made->pool_.get();
  info.MinImageCount = 2;
  info.ImageCount = imageCount;
  info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
  info.Allocator = gpu.device.allocator;
  made->begun_ = ImGui_ImplVulkan_Init(&info, pass);
  if (const auto uploaded = uploadFonts(gpu, commands); !uploaded) return tl::unexpected(uploaded.error());
  return made;
}

ImguiVulkan::~ImguiVulkan() {
  if (begun_) ImGui_ImplVulkan_Shutdown();
}

void ImguiVulkan::record(VkCommandBuffer commands) const {
  ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), commands);
}

}  // namespace honeycomb::Cli::Play
