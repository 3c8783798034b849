#include "apps/cli/play/surface_loader.h"

#include <utility>

namespace honeycomb::Cli::Play {

LoadOptions SurfaceLoader::expected() {
  const std::lock_guard lock(optionsMutex_);
  return options_;
}

Built SurfaceLoader::build(const SurfaceRequest& request) {
  Built built = build_(request);
  if (!built) return built;
  const std::lock_guard lock(mutex_);
  loaded_.reset();
  if (stage_ == nullptr) return built;
  Result<LoadedSurface> loaded = stage_->load(*built, expected());
  if (loaded)
    loaded_ = std::move(*loaded);
  else if (loaded.error().code != ErrorCode::deviceLost)
    return tl::unexpected(inFile((*built)->file(), loaded.error()));
  return built;
}

void SurfaceLoader::useStage(const Stage* stage) {
  const std::lock_guard lock(mutex_);
  loaded_.reset();
  stage_ = stage;
}

void SurfaceLoader::expect(LoadOptions options) {
  const std::lock_guard lock(optionsMutex_);
  options_ = std::move(options);
}

std::optional<LoadedSurface> SurfaceLoader::take(const PlaySurface& surface) {
  const std::lock_guard lock(mutex_);
  if (!loaded_ || loaded_->surface.get() != &surface) return std::nullopt;
  return std::exchange(loaded_, std::nullopt);
}

}  // namespace honeycomb::Cli::Play
