#include "apps/cli/play/stage.h"

#include <fmt/format.h>

#include "apps/cli/chain.h"
#include "apps/cli/play/host_poses.h"
#include "apps/cli/play/rehearsal.h"
#include "io/cache_folder.h"

namespace honeycomb::Cli::Play {
namespace {

template <class Kind>
Result<std::unique_ptr<Viewer::Poses>> onHeap(Result<Kind> poses) {
  if (!poses) return tl::unexpected(poses.error());
  return std::make_unique<Kind>(std::move(*poses));
}

}  // namespace

Stage::Stage(std::unique_ptr<Osd::VulkanContext> context, Result<Osd::VulkanEvaluator> evaluator,
             Viewer::Renderer renderer)
    : context_(std::move(context)), evaluator_(std::move(evaluator)), renderer_(std::move(renderer)) {}
Stage::Stage(Stage&&) noexcept = default;
Stage& Stage::operator=(Stage&& other) noexcept {
  // What is on the device goes before the device does.
  std::swap(context_, other.context_);
  std::swap(evaluator_, other.evaluator_);
  std::swap(renderer_, other.renderer_);
  std::swap(shown_, other.shown_);
  std::swap(posed_, other.posed_);
  return *this;
}
Stage::~Stage() = default;

Result<Stage> Stage::open(const StageOptions& options) {
  auto context = Osd::VulkanContext::create(options.context);
  if (!context) return tl::unexpected(context.error());
  if (!context->supportsGraphics())
    return fail(ErrorCode::noDevice, fmt::format("the Vulkan device '{}' doesn't draw; play needs one that does, such "
                                                 "as Mesa's lavapipe (mesa-vulkan-drivers)",
                                                 context->deviceName()));
  auto owned = std::make_unique<Osd::VulkanContext>(std::move(*context));
  auto renderer = Viewer::Renderer::create(owned->device(), options.picture);
  if (!renderer) return tl::unexpected(renderer.error());
  auto evaluator = Osd::VulkanEvaluator::create(
      owned->device(), {.pipelineCache = Osd::pipelineCacheIn(Io::cacheFolder(), owned->deviceName())});
  return Stage(std::move(owned), std::move(evaluator), std::move(*renderer));
}

Result<LoadedSurface> Stage::load(const std::shared_ptr<const PlaySurface>& surface, const LoadOptions& options) const {
  const Far::Refinement& refinement = surface->refinement();
  const Far::Topology& last = refinement.last().topology;
  const auto colours = Viewer::cellColours(refinement, refinement.levelCount(), options.colouring);
  auto cells = renderer_.upload({last.vertexCount(), last.faceOffsets(), last.vert(), colours});
  if (!cells) return tl::unexpected(cells.error());
  const Far::Topology& control = refinement.level(0).topology;
  auto cage = renderer_.upload(control.vertexCount(), Viewer::edgePairs(control));
  if (!cage) return tl::unexpected(cage.error());
  LoadedSurface loaded{surface, std::move(*cells), std::move(*cage), options.colouring, {}};
  for (const std::string& backend : options.backends) {
    if (auto made = prepare(backend, *surface)) loaded.poses.emplace(backend, std::move(*made));
  }
  return loaded;
}

void Stage::show(LoadedSurface loaded) {
  posed_ = nullptr;
  shown_.poses.clear();
  shown_ = std::move(loaded);
}

Result<void> Stage::show(const std::shared_ptr<const PlaySurface>& surface) {
  auto loaded = load(surface, {{}, shown_.colouring});
  if (!loaded) return tl::unexpected(loaded.error());
  show(std::move(*loaded));
  return {};
}

Result<std::unique_ptr<Viewer::Poses>> Stage::makePoses(const std::string& backend, const PlaySurface& surface) const {
  if (backend != kDeviceBackend) return onHeap(HostPoses::create(backend, surface, renderer_));
  if (!evaluator_) return tl::unexpected(evaluator_.error());
  return onHeap(Viewer::DevicePoses::create(*evaluator_, surface.refinement(), {surface.hasNormals(), true}));
}

Result<std::unique_ptr<Viewer::Poses>> Stage::prepare(const std::string& backend, const PlaySurface& surface) const {
  const auto kernels = [this] { return evaluator_ ? evaluator_->pipelineCount() : 0; };
  const std::size_t before = kernels();
  auto made = makePoses(backend, surface);
  const bool compilesLate = context_->info().type == VK_PHYSICAL_DEVICE_TYPE_CPU;
  if (made && compilesLate && kernels() > before) rehearse(context_->deviceName(), surface);
  return made;
}

void Stage::add(const std::string& backend, std::unique_ptr<Viewer::Poses> poses) {
  shown_.poses.emplace(backend, std::move(poses));
}

Result<Viewer::Poses*> Stage::poses(const std::string& backend) {
  auto& poses = shown_.poses;
  if (const auto found = poses.find(backend); found != poses.end()) return found->second.get();
  auto made = makePoses(backend, surface());
  if (!made) return tl::unexpected(made.error());
  return poses.emplace(backend, std::move(*made)).first->second.get();
}

Result<Viewer::PoseTimes> Stage::pose(const std::string& backend, std::int32_t frame) {
  const auto found = poses(backend);
  if (!found) return tl::unexpected(found.error());
  const auto control = surface().control(frame, storage_);
  if (!control) return tl::unexpected(control.error());
  auto times = (*found)->pose(*control);
  if (!times) return tl::unexpected(surface().ofFrame(frame, times.error()));
  const auto vertices =
      (*found)->refined().first(3 * static_cast<std::size_t>(surface().refinement().last().topology.vertexCount()));
  if (const auto finite = checkFinite<float>(vertices); !finite)
    return tl::unexpected(surface().ofFrame(frame, finite.error()));
  posed_ = *found;
  return times;
}

void Stage::recolour(Viewer::Colouring wanted) {
  if (wanted == shown_.colouring) return;
  const Far::Refinement& refinement = surface().refinement();
  Viewer::Renderer::recolour(shown_.cells, Viewer::cellColours(refinement, refinement.levelCount(), wanted));
  shown_.colouring = wanted;
}

Result<Viewer::Subject> Stage::subject(const Appearance& appearance) {
  if (posed_ == nullptr) return fail(ErrorCode::invalidOption, "there is no pose to draw yet");
  const auto points = posed_->points();
  if (!points) return tl::unexpected(points.error());
  recolour(Viewer::looks()[appearance.look].colouring);
  return Viewer::Subject{.mesh = shown_.cells,
                         .positions = points->refined,
                         .normals = points->normals,
                         .cage = appearance.cage ? &shown_.cage : nullptr,
                         .cagePoints = points->control,
                         .spikes = appearance.normals && surface().hasNormals()};
}

Viewer::View Stage::view(const Appearance& appearance, const Orbit& orbit) const {
  const Viewer::Look& look = Viewer::looks()[appearance.look];
  Viewer::View view{orbit.camera(), surface().bounds(), Viewer::styleOf(look, appearance.edges.value_or(look.edges))};
  if (!surface().hasNormals()) view.style.faceted = true;
  return view;
}

Result<Viewer::Picture> Stage::picture(const Appearance& appearance, const Orbit& orbit) {
  const auto shown = subject(appearance);
  if (!shown) return tl::unexpected(shown.error());
  return renderer_.draw(*shown, view(appearance, orbit));
}

Result<std::size_t> lookNamed(std::string_view name) {
  const auto found = choose(Viewer::looks(), "--view", name);
  if (!found) return tl::unexpected(found.error());
  return static_cast<std::size_t>(*found - Viewer::looks().data());
}

}  // namespace honeycomb::Cli::Play
