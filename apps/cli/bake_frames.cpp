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

/// What one frame of the window works with; nothing is allocated once it is warm.
struct Slot {
  SurfaceEvaluator& evaluator;
  std::vector<float> control;
  Surface<float> surface;
  Result<void> result;
};

/// The frame's points without the vertices that were left out.
void takeVertices(const MeshInput& input, std::span<const float> frame, std::vector<float>& control) {
  control.clear();
  for (const std::int32_t v : input.kept) {
    const auto point = frame.subspan(3 * at(v), 3);
    control.insert(control.end(), point.begin(), point.end());
  }
  if (input.kept.empty()) control.assign(frame.begin(), frame.end());
}

/// The control points of a frame: its vertices, then central control vertices where they are given.
Result<std::span<const float>> controlPoints(const BakeFrames& job, std::int32_t f, std::vector<float>& control) {
  const Result<std::span<const float>> points = job.cache.frame(f);
  if (!points) return tl::unexpected(inFile(job.cacheFile, points.error()));
  if (job.input.kept.empty() && !job.central.given) return points;
  takeVertices(job.input, *points, control);
  if (!job.central.given) return control;
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
  error.message = fmt::format("{}: frame {}: {}", job.cacheFile, frame, error.message);
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

}  // namespace

Result<void> bakeFrames(const BakeFrames& job, const Session& session, Io::Pc2Writer& writer,
                        std::vector<float>* firstFrame) {
  std::vector<Slot> slots;
  for (const auto& evaluator : job.evaluators) slots.push_back({*evaluator, {}, {}, {}});
  const auto atOnce = static_cast<std::int32_t>(slots.size());
  Progress progress(session, "baking", "frames", job.range.count());
  for (std::int32_t first = job.range.begin; first < job.range.end; first += atOnce) {
    const std::int32_t count = std::min(atOnce, job.range.end - first);
    bakeWindow(job, first, count, slots, progress);
    for (std::int32_t i = 0; i < count; ++i) {
      const Slot& slot = slots[at(i)];
      if (!slot.result) return slot.result;
      if (const auto written = writer.write(slot.surface.vertices()); !written) return written;
      if (firstFrame && first + i == job.range.begin)
        firstFrame->assign(slot.surface.vertices().begin(), slot.surface.vertices().end());
    }
  }
  return {};
}

}  // namespace honeycomb::Cli
