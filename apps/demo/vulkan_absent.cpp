#include "apps/demo/vulkan_part.h"

namespace honeycomb::Demo {

struct VulkanPart::State {
  std::string deviceName;
};

VulkanPart::VulkanPart(std::unique_ptr<State> state) : state_(std::move(state)) {}
VulkanPart::VulkanPart(VulkanPart&&) noexcept = default;
VulkanPart& VulkanPart::operator=(VulkanPart&&) noexcept = default;
VulkanPart::~VulkanPart() = default;

Result<VulkanPart> VulkanPart::open() {
  return fail(ErrorCode::noDevice, "this build has no Vulkan; build with -DHONEYCOMB_VULKAN=ON to get it");
}

const std::string& VulkanPart::deviceName() const {
  return state_->deviceName;
}

Result<Contestant> VulkanPart::contestant(const Far::Refinement&) const {
  return tl::unexpected(open().error());
}

Result<std::vector<std::filesystem::path>> VulkanPart::paint(const Animation&, const Far::Topology&, const Far::Scheme&,
                                                             const PictureOptions&) const {
  return tl::unexpected(open().error());
}

}  // namespace honeycomb::Demo
