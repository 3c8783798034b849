#include "apps/cli/play/window/screen.h"

#include <array>
#include <limits>
#include <mutex>

#include "apps/cli/play/window/glfw.h"
#include "apps/cli/play/window/imgui_vulkan.h"
#include "osd/vulkan/errors.h"

namespace honeycomb::Cli::Play {

using Viewer::structure;

struct Screen::State {
  GLFWwindow* window = nullptr;
  Viewer::Gpu gpu;
  WindowCalls calls;
  VkSurfaceKHR surface = VK_NULL_HANDLE;
  Viewer::Owned<VkRenderPass> pass;
  Swapchain chain;
  Viewer::Owned<VkCommandPool> pool;
  VkCommandBuffer commands = VK_NULL_HANDLE;
  Viewer::Owned<VkSemaphore> acquired;
  Viewer::Owned<VkSemaphore> drawn;
  Viewer::Owned<VkFence> done;
  bool onItsWay = false;
  std::unique_ptr<ImguiVulkan> interface;

  ~State();
};

namespace {

constexpr auto kForever = std::numeric_limits<std::uint64_t>::max();

/// The interface is drawn over a picture that was copied into the window's image.
Viewer::Owned<VkRenderPass> makeInterfacePass(Viewer::Maker& make, const Viewer::Gpu& gpu) {
  VkAttachmentDescription colour{};
  colour.format = kWindowFormat;
  colour.samples = VK_SAMPLE_COUNT_1_BIT;
  colour.loadOp = VK_ATTACHMENT_LOAD_OP_LOAD;
  colour.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  colour.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
  colour.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
  colour.initialLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
  colour.finalLayout = VK_IMAGE_LAYOUT_PRESENT_SRC_KHR;
  const VkAttachmentReference reference{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
  VkSubpassDescription subpass{};
  subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
  subpass.colorAttachmentCount = 1;
  subpass.pColorAttachments = &reference;
  const VkSubpassDependency copied{VK_SUBPASS_EXTERNAL,
                                   0,
                                   VK_PIPELINE_STAGE_TRANSFER_BIT,
                                   VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT,
                                   VK_ACCESS_TRANSFER_WRITE_BIT,
                                   VK_ACCESS_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT,
                                   0};
  auto info = structure<VkRenderPassCreateInfo>(VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO);
  info.attachmentCount = 1;
  info.pAttachments = &colour;
  info.subpassCount = 1;
  info.pSubpasses = &subpass;
  info.dependencyCount = 1;
  info.pDependencies = &copied;
  return make.own(gpu.call.vkCreateRenderPass, gpu.call.vkDestroyRenderPass, info, "create a render pass");
}

VkExtent2D sizeOf(GLFWwindow* window) {
  int width = 0;
  int height = 0;
  glfwGetFramebufferSize(window, &width, &height);
  return {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
}

void makeFrameObjects(Viewer::Maker& make, Screen::State& s) {
  auto pool = structure<VkCommandPoolCreateInfo>(VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO);
  pool.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
  pool.queueFamilyIndex = s.gpu.device.queueFamily;
  s.pool = make.own(s.gpu.call.vkCreateCommandPool, s.gpu.call.vkDestroyCommandPool, pool, "create a command pool");
  s.commands = Viewer::allocateCommandBuffer(make, s.gpu, s.pool.get());
  const auto semaphore = structure<VkSemaphoreCreateInfo>(VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO);
  s.acquired = make.own(s.calls.vkCreateSemaphore, s.calls.vkDestroySemaphore, semaphore, "create a semaphore");
  s.drawn = make.own(s.calls.vkCreateSemaphore, s.calls.vkDestroySemaphore, semaphore, "create a semaphore");
  const auto fence = structure<VkFenceCreateInfo>(VK_STRUCTURE_TYPE_FENCE_CREATE_INFO);
  s.done = make.own(s.gpu.call.vkCreateFence, s.gpu.call.vkDestroyFence, fence, "create a fence");
}

/// The window's image takes the picture's bytes.
void recordCopy(const Screen::State& s, VkImage picture, VkImage target) {
  auto barrier = structure<VkImageMemoryBarrier>(VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER);
  barrier.dstAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
  barrier.oldLayout = VK_IMAGE_LAYOUT_UNDEFINED;
  barrier.newLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
  barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = target;
  barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  s.gpu.call.vkCmdPipelineBarrier(s.commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT, 0, 0,
                                  nullptr, 0, nullptr, 1, &barrier);
  VkImageCopy copy{};
  copy.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  copy.dstSubresource = copy.srcSubresource;
  copy.extent = {s.chain.extent().width, s.chain.extent().height, 1};
  s.calls.vkCmdCopyImage(s.commands, picture, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, target,
                         VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &copy);
}

void recordInterface(const Screen::State& s, VkFramebuffer frame) {
  auto info = structure<VkRenderPassBeginInfo>(VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO);
  info.renderPass = s.pass.get();
  info.framebuffer = frame;
  info.renderArea = {{0, 0}, s.chain.extent()};
  s.gpu.call.vkCmdBeginRenderPass(s.commands, &info, VK_SUBPASS_CONTENTS_INLINE);
  s.interface->record(s.commands);
  s.gpu.call.vkCmdEndRenderPass(s.commands);
}

VkResult submitFrame(const Screen::State& s) {
  const VkSemaphore acquired = s.acquired.get();
  const VkSemaphore drawn = s.drawn.get();
  // The renderer's own work needs no window: only the copy into its image waits for that.
  const VkPipelineStageFlags stage = VK_PIPELINE_STAGE_TRANSFER_BIT;
  auto info = structure<VkSubmitInfo>(VK_STRUCTURE_TYPE_SUBMIT_INFO);
  info.waitSemaphoreCount = 1;
  info.pWaitSemaphores = &acquired;
  info.pWaitDstStageMask = &stage;
  info.commandBufferCount = 1;
  info.pCommandBuffers = &s.commands;
  info.signalSemaphoreCount = 1;
  info.pSignalSemaphores = &drawn;
  const VkFence done = s.done.get();
  s.gpu.call.vkResetFences(s.gpu.device.device, 1, &done);
  return Viewer::submit(s.gpu, info, done);
}

VkResult present(const Screen::State& s, std::uint32_t image) {
  const VkSemaphore drawn = s.drawn.get();
  const VkSwapchainKHR chain = s.chain.get();
  auto info = structure<VkPresentInfoKHR>(VK_STRUCTURE_TYPE_PRESENT_INFO_KHR);
  info.waitSemaphoreCount = 1;
  info.pWaitSemaphores = &drawn;
  info.swapchainCount = 1;
  info.pSwapchains = &chain;
  info.pImageIndices = &image;
  const std::lock_guard turn(s.gpu.device.queueLock);
  return s.calls.vkQueuePresentKHR(s.gpu.device.queue, &info);
}

/// For what presenting still reads, which has no fence.
void waitForQueue(const Screen::State& s) {
  const std::lock_guard turn(s.gpu.device.queueLock);
  s.calls.vkQueueWaitIdle(s.gpu.device.queue);
}

}  // namespace

Screen::State::~State() {
  if (calls.vkQueueWaitIdle != nullptr) waitForQueue(*this);
  interface.reset();
  chain = Swapchain();
  if (surface != VK_NULL_HANDLE) calls.vkDestroySurfaceKHR(gpu.device.instance, surface, nullptr);
}

Screen::Screen(std::unique_ptr<State> state) : state_(std::move(state)) {}
Screen::Screen(Screen&&) noexcept = default;
Screen::~Screen() = default;

Result<Screen> Screen::create(GLFWwindow* window, const Osd::VulkanDevice& device) {
  auto state = std::make_unique<State>();
  State& s = *state;
  s.window = window;
  auto gpu = Viewer::openGpu(device);
  if (!gpu) return tl::unexpected(gpu.error());
  s.gpu = *gpu;
  const auto calls = WindowCalls::load(device);
  if (!calls) return tl::unexpected(calls.error());
  s.calls = *calls;
  if (glfwCreateWindowSurface(device.instance, window, nullptr, &s.surface) != VK_SUCCESS)
    return fail(ErrorCode::unsupported, "Vulkan can't draw into this window; write pictures with --headless instead");
  if (const auto shows = Swapchain::check(s.gpu, s.calls, s.surface); !shows) return tl::unexpected(shows.error());
  Viewer::Maker make(s.gpu);
  s.pass = makeInterfacePass(make, s.gpu);
  makeFrameObjects(make, s);
  if (!make.ok()) return tl::unexpected(*make.error());
  Screen screen(std::move(state));
  if (const auto sized = screen.resize(); !sized) return tl::unexpected(sized.error());
  auto interface = ImguiVulkan::create(s.gpu, s.pass.get(), s.commands, std::max(s.chain.count(), 2u));
  if (!interface) return tl::unexpected(interface.error());
  s.interface = std::move(*interface);
  return screen;
}

VkExtent2D Screen::extent() const {
  return state_->chain.extent();
}

Result<void> Screen::resize() {
  State& s = *state_;
  if (auto finished = finishFrame(); !finished) return finished;
  waitForQueue(s);
  auto chain = Swapchain::create(s.gpu, s.calls, s.surface, sizeOf(s.window), s.pass.get(), s.chain);
  if (!chain) return tl::unexpected(chain.error());
  s.chain = std::move(*chain);
  return {};
}

Result<void> Screen::finishFrame() {
  State& s = *state_;
  if (!s.onItsWay) return {};
  const VkFence done = s.done.get();
  const VkResult waited = s.gpu.call.vkWaitForFences(s.gpu.device.device, 1, &done, VK_TRUE, kForever);
  if (waited != VK_SUCCESS) return Osd::vulkanFailure(waited, "finish a picture");
  s.onItsWay = false;
  return {};
}

Result<bool> Screen::show(VkImage picture, const Record& record) {
  State& s = *state_;
  if (const auto finished = finishFrame(); !finished) return tl::unexpected(finished.error());
  std::uint32_t image = 0;
  const VkResult acquired = s.calls.vkAcquireNextImageKHR(s.gpu.device.device, s.chain.get(), kForever,
                                                          s.acquired.get(), VK_NULL_HANDLE, &image);
  if (acquired == VK_ERROR_OUT_OF_DATE_KHR) return false;
  if (acquired != VK_SUCCESS && acquired != VK_SUBOPTIMAL_KHR)
    return Osd::vulkanFailure(acquired, "get a window's image");
  auto begin = structure<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  s.gpu.call.vkBeginCommandBuffer(s.commands, &begin);
  if (record)
    if (const auto recorded = record(s.commands); !recorded) return tl::unexpected(recorded.error());
  recordCopy(s, picture, s.chain.image(image));
  recordInterface(s, s.chain.frame(image));
  s.gpu.call.vkEndCommandBuffer(s.commands);
  if (const VkResult sent = submitFrame(s); sent != VK_SUCCESS) return Osd::vulkanFailure(sent, "submit a picture");
  s.onItsWay = true;
  const VkResult shown = present(s, image);
  if (shown == VK_ERROR_OUT_OF_DATE_KHR || shown == VK_SUBOPTIMAL_KHR) return false;
  if (shown != VK_SUCCESS) return Osd::vulkanFailure(shown, "show a picture");
  return true;
}

}  // namespace honeycomb::Cli::Play
