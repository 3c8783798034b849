#include "apps/demo/vulkan_part.h"

#include <algorithm>

#include "apps/demo/pictures.h"
#include "far/base/stopwatch.h"
#include "io/cache_folder.h"
#include "osd/vulkan/context.h"
#include "osd/vulkan/session.h"

namespace honeycomb::Demo {

struct VulkanPart::State {
  Osd::VulkanContext context;
  Osd::VulkanEvaluatorOptions evaluation;
};

VulkanPart::VulkanPart(std::unique_ptr<State> state) : state_(std::move(state)) {}
VulkanPart::VulkanPart(VulkanPart&&) noexcept = default;
VulkanPart& VulkanPart::operator=(VulkanPart&&) noexcept = default;
VulkanPart::~VulkanPart() = default;

Result<VulkanPart> VulkanPart::open() {
  auto context = Osd::VulkanContext::create();
  if (!context) return tl::unexpected(context.error());
  const auto cache = Osd::pipelineCacheIn(Io::cacheFolder(), context->deviceName());
  return VulkanPart(std::make_unique<State>(State{std::move(*context), {.pipelineCache = cache}}));
}

const std::string& VulkanPart::deviceName() const {
  return state_->context.deviceName();
}

Result<Contestant> VulkanPart::contestant(const Far::Refinement& refinement) const {
  const Stopwatch watch;
  auto evaluator = Osd::VulkanEvaluator::create(state_->context.device(), state_->evaluation);
  if (!evaluator) return tl::unexpected(evaluator.error());
  auto created = Osd::VulkanSession::create(*evaluator, refinement);
  if (!created) return tl::unexpected(created.error());
  auto session = std::make_shared<Osd::VulkanSession>(std::move(*created));
  auto refine = [session, &refinement](std::span<const float> control) -> Result<std::span<const float>> {
    std::ranges::copy(control, session->control().begin());
    if (const auto ran = session->run(); !ran) return tl::unexpected(ran.error());
    return verticesOf(refinement, session->refined());
  };
  return Contestant{"vulkan", watch.milliseconds(), refine};
}

Result<std::vector<std::filesystem::path>> VulkanPart::paint(const Animation& animation, const Far::Topology& control,
                                                             const Far::Scheme& scheme,
                                                             const PictureOptions& options) const {
  if (!state_->context.supportsGraphics()) {
    return fail(ErrorCode::unsupported, state_->context.deviceName() + " computes but does not draw: no pictures");
  }
  return paintPictures(state_->context.device(), state_->evaluation, animation, control, scheme, options);
}

}  // namespace honeycomb::Demo
