#include "apps/cli/bake_frames.h"

#include <fmt/format.h>

#include <atomic>
#include <deque>
#include <mutex>
#include <optional>

#include "apps/cli/frame_control.h"
#include "apps/cli/interrupt.h"
#include "apps/cli/progress.h"
#include "apps/cli/surface_options.h"
#include "far/base/index.h"
#include "far/base/parallel.h"

namespace honeycomb::Cli {
namespace {

/// What one frame after another works with; nothing is allocated once it is warm.
struct Slot {
  SurfaceEvaluator& evaluator;
  FrameStorage control;
  Surface<float> surface;
};

Result<std::span<const float>> controlPoints(const BakeFrames& job, std::int32_t f, FrameStorage& storage) {
  return controlPoints(job.input, &job.animation, job.central, f, storage);
}

Error ofFrame(const BakeFrames& job, std::int32_t frame, Error error) {
  error.message = fmt::format("{}: frame {}: {}", job.animation.file, frame, error.message);
  return error;
}

Result<void> bakeFrame(const BakeFrames& job, std::int32_t frame, Slot& slot) {
  if (interruptSignal() != 0) return fail(ErrorCode::unwritable, "interrupted");
  const Result<std::span<const float>> control = controlPoints(job, frame, slot.control);
  if (!control) return tl::unexpected(control.error());
  Result<void> done = slot.evaluator.evaluate(*control, slot.surface);
  if (done) done = checkFinite<float>(slot.surface.vertices());
  if (!done) return tl::unexpected(ofFrame(job, frame, done.error()));
  return {};
}

/// Where frames come from, where they go, and the first error.
class Run {
 public:
  Run(const BakeFrames& job, const Session& session, const std::vector<std::int32_t>& frames, Ranks& ranks,
      Io::FrameWriter& writer)
      : job_(job),
        frames_(frames),
        ranks_(ranks),
        writer_(writer),
        progress_(session, "baking", "frames", static_cast<double>(frames.size())) {}

  const BakeFrames& job() const { return job_; }
  /// The frame's number in the animation.
  std::int32_t source(std::int32_t frame) const { return job_.animation.range.begin + frame; }
  /// A frame to bake; nothing once there are no more or one had an error. They are handed out in order, so that all
  /// before one that is bad are on their way, and the first bad one is found.
  std::optional<std::int32_t> next() {
    const std::int64_t i = failed_.load() ? kStopped : ranks_.next();
    if (i >= std::ssize(frames_)) return std::nullopt;
    return frames_[at(i)];
  }
  void write(std::int32_t frame, const Surface<float>& surface) {
    if (const auto written = writer_.write(frame, surface.vertices()); !written)
      return keepError(frame, written.error());
    progress_.advance(1);
  }
  void keepError(std::int32_t frame, const Error& error) {
    failed_.store(true);
    ranks_.stop();
    const std::lock_guard lock(mutex_);
    if (outcome_.done || frame < outcome_.frame) outcome_ = {tl::unexpected(error), frame};
  }
  bool failed() const { return failed_.load(); }
  const BakeOutcome& outcome() const { return outcome_; }

 private:
  const BakeFrames& job_;
  const std::vector<std::int32_t>& frames_;
  Ranks& ranks_;
  Io::FrameWriter& writer_;
  Progress progress_;
  std::atomic<bool> failed_{false};
  std::mutex mutex_;
  BakeOutcome outcome_;
};

void bakeOneAfterAnother(Run& run, SurfaceEvaluator& evaluator) {
  Slot slot{evaluator, {}, {}};
  while (const std::optional<std::int32_t> frame = run.next()) {
    if (const auto done = bakeFrame(run.job(), run.source(*frame), slot); !done)
      return run.keepError(*frame, done.error());
    run.write(*frame, slot.surface);
  }
}

void bakeTasks(Run& run) {
  const auto& evaluators = run.job().evaluators.each;
  // A lone evaluator keeps its own threads: no task is put around it.
  if (evaluators.size() == 1) return bakeOneAfterAnother(run, *evaluators.front());
  Parallel::forEach(
      0, std::ssize(evaluators), [&](std::int64_t i) { bakeOneAfterAnother(run, *evaluators[at(i)]); }, 1);
}

Result<void> submitFrame(const BakeFrames& job, std::int32_t frame, FrameStorage& storage) {
  if (interruptSignal() != 0) return fail(ErrorCode::unwritable, "interrupted");
  const Result<std::span<const float>> control = controlPoints(job, frame, storage);
  if (!control) return tl::unexpected(control.error());
  if (const auto sent = job.evaluators.stream->submit(*control); !sent)
    return tl::unexpected(ofFrame(job, frame, sent.error()));
  return {};
}

Result<void> collectFrame(const BakeFrames& job, std::int32_t frame, Surface<float>& surface) {
  Result<void> done = job.evaluators.stream->collect(surface);
  if (done) done = checkFinite<float>(surface.vertices());
  if (!done) return tl::unexpected(ofFrame(job, frame, done.error()));
  return {};
}

/// The oldest frame is collected and written while those behind it are refined. After a frame that can't be sent off,
/// those before it come first, since one of them may have an error too.
void bakeStream(Run& run) {
  FrameStorage control;
  Surface<float> surface;
  std::deque<std::int32_t> underWay;
  std::optional<std::int32_t> frame = run.next();
  while (frame || !underWay.empty()) {
    if (!frame || std::ssize(underWay) == run.job().atOnce()) {
      const std::int32_t oldest = underWay.front();
      underWay.pop_front();
      const auto collected = collectFrame(run.job(), run.source(oldest), surface);
      if (!collected) return run.keepError(oldest, collected.error());
      run.write(oldest, surface);
      if (run.failed()) frame.reset();
    }
    if (!frame) continue;
    const auto sent = submitFrame(run.job(), run.source(*frame), control);
    if (sent) underWay.push_back(*frame);
    if (!sent) run.keepError(*frame, sent.error());
    frame = run.next();
  }
}

}  // namespace

Result<std::vector<float>> bakeFirstFrame(const BakeFrames& job) {
  Slot slot{*job.evaluators.each.front(), {}, {}};
  if (const auto done = bakeFrame(job, job.animation.range.begin, slot); !done) return tl::unexpected(done.error());
  slot.surface.points.resize(slot.surface.vertices().size());
  return std::move(slot.surface.points);
}

BakeOutcome bakeFrames(const BakeFrames& job, const Session& session, const std::vector<std::int32_t>& frames,
                       Ranks& ranks, Io::FrameWriter& writer) {
  Run run(job, session, frames, ranks, writer);
  if (job.evaluators.stream) {
    bakeStream(run);
  } else {
    bakeTasks(run);
  }
  return run.outcome();
}

}  // namespace honeycomb::Cli
