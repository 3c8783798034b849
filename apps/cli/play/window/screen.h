#pragma once

#include <functional>
#include <memory>

#include "apps/cli/play/window/swapchain.h"
#include "apps/viewer/renderer.h"

struct GLFWwindow;

namespace honeycomb::Cli::Play {

/// What a device shows in a window: pictures of the renderer's, and the interface over them. One frame is on its way at
/// a time. Belongs to the thread of the window.
class Screen {
 public:
  struct State;

  /// Both outlive the screen; ImGui's context and its GLFW side are there. Errors: unsupported, outOfMemory,
  /// deviceLost.
  static Result<Screen> create(GLFWwindow* window, const Osd::VulkanDevice& device);
  Screen(Screen&&) noexcept;
  Screen& operator=(Screen&&) = delete;
  ~Screen();

  /// Waits until the frame before is drawn; what it used may be changed then. Errors: deviceLost.
  Result<void> finishFrame();

  /// Draws a frame: what `record` draws, unless it is empty, into the renderer's image; that image, and ImGui's draw
  /// data over it. `picture` has the window's size. True where it was shown, false where the window's size has changed
  /// meanwhile and resize() is due. Errors: deviceLost, those of `record`.
  using Record = std::function<Result<void>(VkCommandBuffer)>;
  Result<bool> show(VkImage picture, const Record& record);

  /// New images, of the window's present size. Errors: as of create.
  Result<void> resize();
  VkExtent2D extent() const;

 private:
  explicit Screen(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace honeycomb::Cli::Play
