#pragma once

#include <vector>

#include "apps/cli/play/window/calls.h"
#include "apps/viewer/gpu.h"

namespace honeycomb::Cli::Play {

/// What windows have images of nearly everywhere, and the renderer's pictures with the same bytes.
constexpr VkFormat kWindowFormat = VK_FORMAT_B8G8R8A8_UNORM;
constexpr VkFormat kWindowPictureFormat = VK_FORMAT_B8G8R8A8_SRGB;

/// The images of a window, in a format whose bytes are those of the renderer's pictures: 8 bits a channel, sRGB as it
/// stands.
class Swapchain {
 public:
  /// Errors: unsupported where the surface has no images of kWindowFormat, or the device's queue can't show anything on
  /// it.
  static Result<void> check(const Viewer::Gpu& gpu, const WindowCalls& calls, VkSurfaceKHR surface);

  /// Images of about that size (the surface may want another), taking the place of `before`, which may be empty.
  /// Errors: unsupported, outOfMemory, deviceLost.
  static Result<Swapchain> create(const Viewer::Gpu& gpu, const WindowCalls& calls, VkSurfaceKHR surface,
                                  VkExtent2D wanted, VkRenderPass pass, const Swapchain& before);
  Swapchain() = default;

  VkExtent2D extent() const { return extent_; }
  VkSwapchainKHR get() const { return chain_.get(); }
  VkImage image(std::uint32_t i) const { return images_[i]; }
  VkFramebuffer frame(std::uint32_t i) const { return frames_[i].get(); }
  std::uint32_t count() const { return static_cast<std::uint32_t>(images_.size()); }

 private:
  void makeFrames(Viewer::Maker& make, const Viewer::Gpu& gpu, VkRenderPass pass);

  VkExtent2D extent_{};
  Viewer::Owned<VkSwapchainKHR> chain_;
  std::vector<VkImage> images_;
  std::vector<Viewer::Owned<VkImageView>> views_;
  std::vector<Viewer::Owned<VkFramebuffer>> frames_;
};

}  // namespace honeycomb::Cli::Play
