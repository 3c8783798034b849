#pragma once

#include <memory>

#include "apps/viewer/gpu.h"

namespace honeycomb::Cli::Play {

/// Draws ImGui's windows with Vulkan: its own backend, compiled here with our functions in the place of a linked
/// loader's. One at a time lives.
class ImguiVulkan {
 public:
  /// `commands`: a command buffer of the device's queue for the fonts, used and done with when this returns. `pass`:
  /// where it is drawn later. Errors: unsupported, outOfMemory, deviceLost.
  static Result<std::unique_ptr<ImguiVulkan>> create(const Viewer::Gpu& gpu, VkRenderPass pass,
                                                     VkCommandBuffer commands, std::uint32_t imageCount);
  ~ImguiVulkan();
  ImguiVulkan(const ImguiVulkan&) = delete;
  ImguiVulkan& operator=(const ImguiVulkan&) = delete;

  /// The draw data of ImGui::Render(), within the pass.
  void record(VkCommandBuffer commands) const;

 private:
  ImguiVulkan() = default;
  Viewer::Owned<VkDescriptorPool> pool_;
  bool begun_ = false;
};

}  // namespace honeycomb::Cli::Play
