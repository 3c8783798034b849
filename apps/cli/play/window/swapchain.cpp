#include "apps/cli/play/window/swapchain.h"

#include <algorithm>

namespace honeycomb::Cli::Play {
namespace {

using Viewer::structure;

VkExtent2D extentFor(const VkSurfaceCapabilitiesKHR& surface, VkExtent2D wanted) {
  constexpr std::uint32_t kAsYouLike = 0xffffffff;
  if (surface.currentExtent.width != kAsYouLike) return surface.currentExtent;
  return {std::clamp(wanted.width, surface.minImageExtent.width, surface.maxImageExtent.width),
          std::clamp(wanted.height, surface.minImageExtent.height, surface.maxImageExtent.height)};
}

VkSwapchainCreateInfoKHR chainInfo(const VkSurfaceCapabilitiesKHR& surface, VkExtent2D extent) {
  auto info = structure<VkSwapchainCreateInfoKHR>(VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR);
  const std::uint32_t most = surface.maxImageCount == 0 ? surface.minImageCount + 1 : surface.maxImageCount;
  info.minImageCount = std::min(surface.minImageCount + 1, most);
  info.imageFormat = kWindowFormat;
  info.imageColorSpace = VK_COLOR_SPACE_SRGB_NONLINEAR_KHR;
  info.imageExtent = extent;
  info.imageArrayLayers = 1;
  info.imageUsage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  info.imageSharingMode = VK_SHARING_MODE_EXCLUSIVE;
  info.preTransform = surface.currentTransform;
  info.compositeAlpha = VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR;
  info.presentMode = VK_PRESENT_MODE_FIFO_KHR;
  info.clipped = VK_TRUE;
  return info;
}

}  // namespace

Result<void> Swapchain::check(const Viewer::Gpu& gpu, const WindowCalls& calls, VkSurfaceKHR surface) {
  VkBool32 shows = VK_FALSE;
  calls.vkGetPhysicalDeviceSurfaceSupportKHR(gpu.device.physicalDevice, gpu.device.queueFamily, surface, &shows);
  std::uint32_t count = 0;
  calls.vkGetPhysicalDeviceSurfaceFormatsKHR(gpu.device.physicalDevice, surface, &count, nullptr);
  std::vector<VkSurfaceFormatKHR> formats(count);
  calls.vkGetPhysicalDeviceSurfaceFormatsKHR(gpu.device.physicalDevice, surface, &count, formats.data());
  for (const VkSurfaceFormatKHR& format : formats)
    if (shows && format.format == kWindowFormat && format.colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR) return {};
  return fail(ErrorCode::unsupported,
              "the Vulkan device can't show 8-bit colours in this window; write pictures with --headless instead");
}

Result<Swapchain> Swapchain::create(const Viewer::Gpu& gpu, const WindowCalls& calls, VkSurfaceKHR surface,
                                    VkExtent2D wanted, VkRenderPass pass, const Swapchain& before) {
  Viewer::Maker make(gpu);
  VkSurfaceCapabilitiesKHR capabilities{};
  make.check(calls.vkGetPhysicalDeviceSurfaceCapabilitiesKHR(gpu.device.physicalDevice, surface, &capabilities),
             "look at a window");
  VkSwapchainCreateInfoKHR info = chainInfo(capabilities, extentFor(capabilities, wanted));
  info.surface = surface;
  info.oldSwapchain = before.get();
  Swapchain made;
  made.extent_ = info.imageExtent;
  made.chain_ = make.own(calls.vkCreateSwapchainKHR, calls.vkDestroySwapchainKHR, info, "make a window's images");
  if (!make.ok()) return tl::unexpected(*make.error());
  std::uint32_t count = 0;
  make.check(calls.vkGetSwapchainImagesKHR(gpu.device.device, made.get(), &count, nullptr), "count a window's images");
  made.images_.resize(count);
  if (make.ok())
    make.check(calls.vkGetSwapchainImagesKHR(gpu.device.device, made.get(), &count, made.images_.data()),
               "get a window's images");
  made.makeFrames(make, gpu, pass);
  if (!make.ok()) return tl::unexpected(*make.error());
  return made;
}

void Swapchain::makeFrames(Viewer::Maker& make, const Viewer::Gpu& gpu, VkRenderPass pass) {
  for (const VkImage image : images_) {
    auto view = structure<VkImageViewCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO);
    view.image = image;
    view.viewType = VK_IMAGE_VIEW_TYPE_2D;
    view.format = kWindowFormat;
    view.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    views_.push_back(make.own(gpu.call.vkCreateImageView, gpu.call.vkDestroyImageView, view, "create an image view"));
    const VkImageView attachment = views_.back().get();
    auto frame = structure<VkFramebufferCreateInfo>(VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO);
    frame.renderPass = pass;
    frame.attachmentCount = 1;
    frame.pAttachments = &attachment;
    frame.width = extent_.width;
    frame.height = extent_.height;
    frame.layers = 1;
    frames_.push_back(
        make.own(gpu.call.vkCreateFramebuffer, gpu.call.vkDestroyFramebuffer, frame, "create a framebuffer"));
  }
}

}  // namespace honeycomb::Cli::Play
