#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "apps/cli/play/background_work.h"
#include "apps/cli/play/stage.h"

namespace honeycomb::Cli::Play {

/// Builds surfaces and brings them to a stage's device on the thread that builds them, so that the thread that draws
/// the one before only has to exchange the two.
class SurfaceLoader {
 public:
  explicit SurfaceLoader(BackgroundBuild::Build build = PlaySurface::build) : build_(std::move(build)) {}

  /// Any thread. Without a stage, or where its device is lost meanwhile, the surface alone. Errors: those of building
  /// and of Stage::load.
  Built build(const SurfaceRequest& request);

  /// The rest belongs to the thread of the stage.
  /// From now on surfaces are brought to this stage; null: to none. Waits until the one before is out of use.
  void useStage(const Stage* stage);
  /// What refines the next surfaces' frames, and how they are coloured.
  void expect(LoadOptions options);
  /// What has been brought of a surface, once; nothing where that is none.
  std::optional<LoadedSurface> take(const PlaySurface& surface);

 private:
  LoadOptions expected();

  BackgroundBuild::Build build_;
  std::mutex optionsMutex_;
  LoadOptions options_;
  std::mutex mutex_;  // of the rest; held while a surface is being brought
  const Stage* stage_ = nullptr;
  std::optional<LoadedSurface> loaded_;
};

}  // namespace honeycomb::Cli::Play
