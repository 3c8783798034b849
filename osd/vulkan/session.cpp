#include "osd/vulkan/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "osd/vulkan/guard.h"

namespace honeycomb::Osd {

Result<VulkanSession> VulkanSession::create(VulkanEvaluator& evaluator, const Far::Refinement& refinement,
                                            const VulkanTableOptions& options) {
  const auto table = evaluator.upload(refinement, options);
  if (!table) return tl::unexpected(table.error());
  return create(std::as_const(evaluator), *table);
}

Result<VulkanSession> VulkanSession::create(const VulkanEvaluator& evaluator, const VulkanTable& table,
                                            const VulkanBindingOptions& options) {
  return guarded([&]() -> Result<VulkanSession> {
    auto slot =
        FrameSlot::create(evaluator, table, {.timing = options.timing, .readers = VK_PIPELINE_STAGE_ALL_COMMANDS_BIT});
    if (!slot) return tl::unexpected(slot.error());
    return VulkanSession(std::move(*slot));
  });
}

Result<void> VulkanSession::run() {
  return guarded([this]() -> Result<void> {
    if (auto fresh = slot_.refresh(); !fresh) return fresh;
    if (auto sent = slot_.commands().submit(); !sent) return sent;
    return slot_.commands().wait();
  });
}

Result<void> VulkanSession::refine(std::span<const float> points, std::span<float> refined) {
  return guarded([&]() -> Result<void> {
    if (points.size() != control().size() || refined.size() != this->refined().size()) {
      return fail(ErrorCode::invalidOption,
                  fmt::format("{} numbers in and {} out: the table reads {} and writes {}", points.size(),
                              refined.size(), control().size(), this->refined().size()));
    }
    std::ranges::copy(points, control().begin());
    if (auto ran = run(); !ran) return ran;
    std::ranges::copy(this->refined(), refined.begin());
    return {};
  });
}

}  // namespace honeycomb::Osd
