#pragma once

#include <functional>
#include <future>
#include <optional>

#include "apps/cli/play/surface.h"

namespace honeycomb::Cli::Play {

using Built = Result<std::shared_ptr<const PlaySurface>>;

/// Builds surfaces on a thread of its own, one after another, while the caller goes on. Belongs to one thread.
class BackgroundBuild {
 public:
  using Build = std::function<Built(const SurfaceRequest&)>;
  explicit BackgroundBuild(Build build) : build_(std::move(build)) {}
  /// Waits for what is being built.
  ~BackgroundBuild() = default;

  /// Builds that as soon as what is being built is done; what was asked for in between is not built at all.
  void ask(SurfaceRequest request);
  bool busy() const { return running_.valid() || next_.has_value(); }

  struct Outcome {
    SurfaceRequest request;
    Built built;
  };
  /// What has been built, once; nothing while it is being built, and nothing of a request that a newer one has
  /// followed.
  std::optional<Outcome> poll();

 private:
  void start(SurfaceRequest request);

  Build build_;
  std::optional<SurfaceRequest> current_;
  std::optional<SurfaceRequest> next_;
  std::future<Built> running_;
};

}  // namespace honeycomb::Cli::Play
