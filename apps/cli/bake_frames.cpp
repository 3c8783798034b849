#include "apps/cli/bake_frames.h"

#include <fmt/format.h>

#include <algorithm>

#include "apps/cli/interrupt.h"
#include "apps/cli/progress.h"
#include "apps/cli/surface_options.h"
#include "far/base/index.h"
#include "far/base/parallel.h"

namespace honeycomb::Cli {
namespace {

/// What turns a frame into control points.
struct ControlStorage {
  std::vector<float> frame;    // where the animation has to compute it
  std::vector<float> control;  // where it isn't the frame as it stands
};

/// What one frame of the window works with; nothing is allocated once it is warm.
struct Slot {
  SurfaceEvaluator& evaluator;
  ControlStorage control;
  Surface<float> surface;
  Result<void> result;
};

/// The control points of a frame: its vertices, then central control vertices where they are given.
Result<std::span<const float>> controlPoints(const BakeFrames& job, std::int32_t f, ControlStorage& storage) {
  const Result<std::span<const float>> points = job.animation.frames->frame(f, storage.frame);
  if (!points) return tl::unexpected(inFile(job.animation.file, points.error()));
  std::vector<float>& control = storage.control;
  const std::span<const float> vertices = takeVertices(job.input, *points, control);
  if (!job.central.given) return vertices;
  if (vertices.data() != control.data()) control.assign(vertices.begin(), vertices.end());
  if (!job.central.cache) {
    appendOffsetPoints(job.input.mesh.polygons, job.central.offsets, control);
    return control;
  }
  const Result<std::span<const float>> central = job.central.cache->frame(f);
  if (!central) return tl::unexpected(inFile(job.central.file, central.error()));
  control.insert(control.end(), central->begin(), central->end());
  return control;
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

/// Refines the frames first .. first+count-1, each in its slot.
void bakeWindow(const BakeFrames& job, std::int32_t first, std::int32_t count, std::vector<Slot>& slots,
                Progress& progress) {
  const auto bakeSlot = [&](std::int64_t i) {
    slots[at(i)].result = bakeFrame(job, first + static_cast<std::int32_t>(i), slots[at(i)]);
    progress.advance(1);
  };
  // A lone frame keeps its evaluator's own threads: no task is put around it.
  if (count == 1) return bakeSlot(0);
  Parallel::forEach(0, count, bakeSlot, 1);
}

/// Where refined frames go.
struct Sink {
  const BakeFrames& job;
  Io::Pc2Writer& writer;
  std::vector<float>* firstFrame;

  Result<void> write(std::int32_t frame, const Surface<float>& surface) const {
    if (const auto written = writer.write(surface.vertices()); !written) return written;
    if (firstFrame && frame == job.animation.range.begin)
      firstFrame->assign(surface.vertices().begin(), surface.vertices().end());
    return {};
  }
};

Result<void> bakeTasks(const BakeFrames& job, const Sink& sink, Progress& progress) {
  std::vector<Slot> slots;
  for (const auto& evaluator : job.evaluators.each) slots.push_back({*evaluator, {}, {}, {}});
  for (std::int32_t first = job.animation.range.begin; first < job.animation.range.end; first += job.atOnce()) {
    const std::int32_t count = std::min(job.atOnce(), job.animation.range.end - first);
    bakeWindow(job, first, count, slots, progress);
    for (std::int32_t i = 0; i < count; ++i) {
      const Slot& slot = slots[at(i)];
      if (!slot.result) return slot.result;
      if (const auto written = sink.write(first + i, slot.surface); !written) return written;
    }
  }
  return {};
}

Result<void> submitFrame(const BakeFrames& job, std::int32_t frame, ControlStorage& storage) {
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

/// The frame `depth` before is collected and written while those between are refined. After a frame that can't be sent
/// off, those before it come first, since one of them may have an error too.
Result<void> bakeStream(const BakeFrames& job, const Sink& sink, Progress& progress) {
  ControlStorage control;
  Surface<float> surface;
  Result<void> sent;
  std::int32_t end = job.animation.range.end;
  for (std::int32_t frame = job.animation.range.begin; frame < end + job.atOnce(); ++frame) {
    const std::int32_t oldest = frame - job.atOnce();
    if (oldest >= job.animation.range.begin) {
      if (const auto collected = collectFrame(job, oldest, surface); !collected) return collected;
      if (const auto written = sink.write(oldest, surface); !written) return written;
      progress.advance(1);
    }
    if (frame < end) sent = submitFrame(job, frame, control);
    if (!sent) end = std::min(end, frame);
  }
  return sent;
}

}  // namespace

Result<void> bakeFrames(const BakeFrames& job, const Session& session, Io::Pc2Writer& writer,
                        std::vector<float>* firstFrame) {
  Progress progress(session, "baking", "frames", job.animation.range.count());
  const Sink sink{job, writer, firstFrame};
  return job.evaluators.stream ? bakeStream(job, sink, progress) : bakeTasks(job, sink, progress);
}

}  // namespace honeycomb::Cli
