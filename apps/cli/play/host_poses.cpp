#include "apps/cli/play/host_poses.h"

#include <fmt/format.h>

#include <cstring>

#include "apps/cli/chain.h"
#include "far/base/index.h"
#include "far/base/stopwatch.h"

namespace honeycomb::Cli::Play {
namespace {

Result<Viewer::Buffer> bufferFor(const Viewer::Renderer& renderer, std::int64_t points) {
  const std::vector<float> zeros(3 * at(points));
  return renderer.uploadPoints(zeros);
}

void copy(std::span<const float> numbers, const Viewer::Buffer& buffer) {
  if (!numbers.empty()) std::memcpy(buffer.mapped, numbers.data(), numbers.size_bytes());
}

}  // namespace

Result<HostPoses> HostPoses::create(std::string_view name, const PlaySurface& surface,
                                    const Viewer::Renderer& renderer) {
  const auto entry = choose(backends(), "--backend", name);
  if (!entry) return tl::unexpected(entry.error());
  auto backend = (*entry)->open();
  if (!backend) return tl::unexpected(backend.error());
  const Far::Refinement& refinement = surface.refinement();
  auto evaluator = (*backend)->evaluator(refinement, surface.hasNormals() ? Normals::exact : Normals::none);
  if (!evaluator) return tl::unexpected(evaluator.error());
  FrameStorage storage;
  const auto control = surface.control(0, storage);
  if (!control) return tl::unexpected(control.error());
  const std::int64_t refinedCount = refinement.last().topology.vertexCount();
  auto first = bufferFor(renderer, std::ssize(*control) / 3);
  auto second = bufferFor(renderer, refinedCount);
  auto third = bufferFor(renderer, refinedCount);
  for (const auto* made : {&first, &second, &third})
    if (!*made) return tl::unexpected(made->error());
  HostPoses poses;
  poses.backend_ = std::move(*backend);
  poses.evaluator_ = std::move(*evaluator);
  poses.control_ = std::move(*first);
  poses.refined_ = std::move(*second);
  poses.normals_ = std::move(*third);
  return poses;
}

Result<Viewer::PoseTimes> HostPoses::pose(std::span<const float> control) {
  if (control.size_bytes() != control_.size)
    return fail(ErrorCode::invalidOption, fmt::format("a frame of {} numbers was given to a mesh of {} control points",
                                                      control.size(), control_.size / (3 * sizeof(float))));
  Stopwatch watch;
  if (const auto done = evaluator_->evaluate(control, surface_); !done) return tl::unexpected(done.error());
  Viewer::PoseTimes times;
  times.evaluate = watch.lap();
  copy(control, control_);
  copy(surface_.vertices(), refined_);
  copy(surface_.normals, normals_);
  times.upload = watch.lap();
  posed_ = true;
  return times;
}

Result<Viewer::PosedPoints> HostPoses::points() const {
  if (!posed_) return fail(ErrorCode::invalidOption, "there is no pose to draw yet");
  return Viewer::PosedPoints{{control_.get(), 0, 3}, {refined_.get(), 0, 3}, {normals_.get(), 0, 3}};
}

std::span<const float> HostPoses::refined() const {
  return posed_ ? surface_.vertices() : std::span<const float>();
}

}  // namespace honeycomb::Cli::Play
