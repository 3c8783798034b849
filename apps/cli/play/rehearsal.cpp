#include "apps/cli/play/rehearsal.h"

#include "apps/viewer/poses.h"
#include "osd/vulkan/context.h"

namespace honeycomb::Cli::Play {

void rehearse(const std::string& device, const PlaySurface& surface) {
  const auto context = Osd::VulkanContext::create({.device = device});
  if (!context) return;
  const auto evaluator = Osd::VulkanEvaluator::create(context->device());
  if (!evaluator) return;
  auto poses = Viewer::DevicePoses::create(*evaluator, surface.refinement(), {surface.hasNormals()});
  FrameStorage storage;
  const auto control = surface.control(0, storage);
  if (poses && control) static_cast<void>(poses->pose(*control));
}

}  // namespace honeycomb::Cli::Play
