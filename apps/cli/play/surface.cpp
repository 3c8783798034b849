#include "apps/cli/play/surface.h"

#include <fmt/format.h>

#include <algorithm>

#include "far/base/index.h"
#include "far/base/stopwatch.h"

namespace honeycomb::Cli::Play {
namespace {

constexpr std::int32_t kOutlineFrames = 8;
constexpr std::size_t kOutlinePoints = 20000;  ///< a frame

/// Every so many-th point, so that there are not too many.
void addThinned(std::span<const float> points, std::vector<float>& outline) {
  const std::size_t count = points.size() / 3;
  const std::size_t step = 1 + count / kOutlinePoints;
  for (std::size_t i = 0; i < count; i += step)
    outline.insert(outline.end(), points.begin() + std::ptrdiff_t(3 * i), points.begin() + std::ptrdiff_t(3 * i + 3));
}

}  // namespace

Result<std::shared_ptr<const PlaySurface>> PlaySurface::build(const SurfaceRequest& request) {
  const Stopwatch watch;
  SurfaceOptions options = request.surface;
  options.backend = "serial";  // needs nothing of the machine: what refines is opened where it is used
  Result<SurfacePlan> plan = planSurface(options, sizeof(float));
  if (!plan) return tl::unexpected(plan.error());
  const std::shared_ptr<PlaySurface> made(new PlaySurface(std::move(*plan)));
  if (const auto read = made->readInput(request); !read) return tl::unexpected(read.error());
  if (const auto measured = made->measure(); !measured) return tl::unexpected(measured.error());
  made->buildMs_ = watch.milliseconds();
  return std::shared_ptr<const PlaySurface>(made);
}

Result<void> PlaySurface::readInput(const SurfaceRequest& request) {
  const MeshInput& input = plan_.mesh.input;
  if (!request.animation.cache.empty() || input.frames) {
    Result<Animation> animation = openAnimation(request.animation, input);
    if (!animation) return tl::unexpected(animation.error());
    animation_ = std::move(*animation);
  } else if (!request.animation.frames.empty() || input.framesPerSecond) {
    return fail(
        ErrorCode::invalidOption,
        fmt::format("{}: {} holds one pose only; name its animation with --cache FILE.pc2",
                    request.animation.frames.empty() ? "--fps" : "--frames " + request.animation.frames, input.file));
  }
  const SchemeOptions& scheme = request.surface.scheme;
  Result<CentralPoints> central = animation_ ? readCentralCache(scheme, input, animation_->frames->info().frameCount)
                                             : readCentralPoints(scheme, input);
  if (!central) return tl::unexpected(central.error());
  central_ = std::move(*central);
  Result<Far::Refinement> refinement = buildTables(plan_, {1, sizeof(float), hasNormals(), central_.given});
  if (!refinement) return tl::unexpected(refinement.error());
  refinement_.emplace(std::move(*refinement));
  return {};
}

Result<void> PlaySurface::measure() {
  const auto backend = openTbb();
  if (!backend) return tl::unexpected(backend.error());
  const auto evaluator = (*backend)->evaluator(*refinement_, Normals::none);
  if (!evaluator) return tl::unexpected(evaluator.error());
  const std::int32_t count = std::min(frameCount(), kOutlineFrames);
  FrameStorage storage;
  Surface<float> surface;
  for (std::int32_t i = 0; i < count; ++i) {
    const auto frame = static_cast<std::int32_t>(std::int64_t{i} * frameCount() / count);
    const auto points = control(frame, storage);
    if (!points) return tl::unexpected(points.error());
    Result<void> done = (*evaluator)->evaluate(*points, surface);
    if (done) done = checkFinite<float>(surface.vertices());
    if (!done) return tl::unexpected(ofFrame(frame, done.error()));
    const Viewer::Bounds box = Viewer::boundsOf(surface.vertices());
    bounds_ = i == 0 ? box : Viewer::unite(bounds_, box);
    addThinned(surface.vertices(), outline_);
  }
  return {};
}

double PlaySurface::framesPerSecond() const {
  return animation_ ? animation_->frames->info().playedAt() : Io::kUsualFramesPerSecond;
}

Result<std::span<const float>> PlaySurface::control(std::int32_t frame, FrameStorage& storage) const {
  return controlPoints(plan_.mesh.input, animation_ ? &*animation_ : nullptr, central_, frameNumber(frame), storage);
}

Error PlaySurface::ofFrame(std::int32_t frame, Error error) const {
  if (animation_) error.message = fmt::format("{}: frame {}: {}", animation_->file, frameNumber(frame), error.message);
  return inFile(file(), error);
}

}  // namespace honeycomb::Cli::Play
