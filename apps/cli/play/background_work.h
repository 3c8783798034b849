#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <new>
#include <optional>
#include <utility>

#include "apps/cli/play/surface.h"
#include "far/base/result.h"

namespace honeycomb::Cli::Play {

/// Does one thing after another on a thread of its own, while the caller goes on. Belongs to one thread.
template <class Request, class Value>
class BackgroundWork {
 public:
  using Build = std::function<Result<Value>(const Request&)>;
  explicit BackgroundWork(Build build) : build_(std::move(build)) {}
  /// Waits for what is being done.
  ~BackgroundWork() = default;

  /// Does that as soon as what is being done is; what was asked for in between is not done at all.
  void ask(Request request) {
    if (running_.valid())
      next_ = std::move(request);
    else
      start(std::move(request));
  }
  bool busy() const { return running_.valid() || next_.has_value(); }

  struct Outcome {
    Request request;
    Result<Value> built;
  };
  /// What has been done, once; nothing meanwhile, and nothing of a request that a newer one has followed.
  std::optional<Outcome> poll() {
    if (!running_.valid() || running_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
      return std::nullopt;
    Outcome outcome{std::move(*current_), running_.get()};
    if (!next_) return outcome;
    Request request = std::move(*next_);
    next_.reset();
    start(std::move(request));
    return std::nullopt;
  }

 private:
  void start(Request request) {
    current_ = std::move(request);
    running_ = std::async(std::launch::async, [build = build_, wanted = *current_]() -> Result<Value> {
      try {
        return build(wanted);
      } catch (const std::bad_alloc&) {
        return fail(ErrorCode::outOfMemory, "out of memory; use fewer levels");
      }
    });
  }

  Build build_;
  std::optional<Request> current_;
  std::optional<Request> next_;
  std::future<Result<Value>> running_;
};

using BackgroundBuild = BackgroundWork<SurfaceRequest, std::shared_ptr<const PlaySurface>>;
using Built = Result<std::shared_ptr<const PlaySurface>>;

}  // namespace honeycomb::Cli::Play
