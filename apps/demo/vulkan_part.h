#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "apps/demo/contest.h"

namespace honeycomb::Demo {

struct PictureOptions {
  std::filesystem::path folder;
  std::int32_t levels = 4;
  std::int32_t frameCount = 1;
};

/// All that the demo does with Vulkan, behind one door, so that it also runs in a build without.
class VulkanPart {
 public:
  /// Opens the best device there is. Errors: noDevice.
  static Result<VulkanPart> open();
  VulkanPart(VulkanPart&&) noexcept;
  VulkanPart& operator=(VulkanPart&&) noexcept;
  ~VulkanPart();

  const std::string& deviceName() const;
  /// Compiles and uploads what the evaluator needs.
  Result<Contestant> contestant(const Far::Refinement& refinement) const;
  /// Pictures of some frames and a sheet of many: returns the files written. Errors: also unwritable.
  Result<std::vector<std::filesystem::path>> paint(const Animation& animation, const Far::Topology& control,
                                                   const Far::Scheme& scheme, const PictureOptions& options) const;

 private:
  struct State;
  explicit VulkanPart(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace honeycomb::Demo
