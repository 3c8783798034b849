#include "apps/cli/play/background_build.h"

#include <chrono>
#include <new>

namespace honeycomb::Cli::Play {

void BackgroundBuild::start(SurfaceRequest request) {
  current_ = std::move(request);
  running_ = std::async(std::launch::async, [build = build_, wanted = *current_]() -> Built {
    try {
      return build(wanted);
    } catch (const std::bad_alloc&) {
      return fail(ErrorCode::outOfMemory, "out of memory; use fewer levels");
    }
  });
}

void BackgroundBuild::ask(SurfaceRequest request) {
  if (running_.valid())
    next_ = std::move(request);
  else
    start(std::move(request));
}

std::optional<BackgroundBuild::Outcome> BackgroundBuild::poll() {
  if (!running_.valid() || running_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
  Outcome outcome{std::move(*current_), running_.get()};
  if (!next_) return outcome;
  SurfaceRequest request = std::move(*next_);
  next_.reset();
  start(std::move(request));
  return std::nullopt;
}

}  // namespace honeycomb::Cli::Play
