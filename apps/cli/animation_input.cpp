#include "apps/cli/animation_input.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "apps/cli/formats.h"
#include "far/base/index.h"
#include "io/resampled_frames.h"

namespace honeycomb::Cli {
namespace {

Result<std::shared_ptr<const Io::FrameSource>> openFrames(const AnimationOptions& options, const MeshInput& input) {
  if (options.cache.empty()) {
    if (input.frames) return input.frames;
    return fail(ErrorCode::invalidOption,
                fmt::format("{}: holds one pose only; name its animation with --cache FILE.pc2 (or .mdd)", input.file));
  }
  const auto format = pointCache(options.cache);
  if (!format) return tl::unexpected(format.error());
  auto cache = (*format)->open(options.cache);
  if (!cache) return tl::unexpected(inFile(options.cache, cache.error()));
  return cache;
}

using Frames = std::shared_ptr<const Io::FrameSource>;

Result<Frames> atRate(Frames frames, std::optional<double> framesPerSecond, const std::string& file) {
  if (!framesPerSecond) return frames;
  // A clip has been sampled at this rate already.
  const float has = frames->info().framesPerSecond;
  if (has > 0 && has == static_cast<float>(*framesPerSecond)) return frames;
  const double made = frames->info().playedAt();
  auto resampled = Io::ResampledFrames::create(std::move(frames), made, *framesPerSecond);
  if (!resampled) return tl::unexpected(inFile(file, resampled.error()));
  return resampled;
}

}  // namespace

void addAnimationOptions(CLI::App& subcommand, AnimationOptions& options, ReadOptions& read) {
  subcommand.add_option("--cache", options.cache, "Point cache that animates IN (.pc2, .mdd)");
  subcommand.add_option("--frames", options.frames, "Frames a:b of the animation, b not included (default: all)");
  subcommand.add_option("--fps", read.framesPerSecond,
                        "Frames a second at which the animation is sampled; what doesn't say its own rate (.pc2, "
                        "sequences) has 24 (default: as it was made)");
}

Result<Animation> openAnimation(const AnimationOptions& options, const MeshInput& input) {
  const std::string& file = options.cache.empty() ? input.file : options.cache;
  const auto frames = openFrames(options, input).and_then([&](Frames opened) {
    return atRate(std::move(opened), input.framesPerSecond, file);
  });
  if (!frames) return tl::unexpected(frames.error());
  const Io::FrameInfo& info = (*frames)->info();
  if (info.pointCount != input.fileVertices)
    return fail(ErrorCode::invalidFile,
                fmt::format("{}: has {} points a frame, but {} has {} vertices; take the mesh the cache was made for",
                            file, info.pointCount, input.file, input.fileVertices));
  const Result<FrameRange> range = parseFrameRange(options.frames, info.frameCount);
  if (!range) return tl::unexpected(range.error());
  return Animation{*frames, *range, file};
}

std::span<const float> takeVertices(const MeshInput& input, std::span<const float> frame, std::vector<float>& storage) {
  if (input.kept.empty()) return frame;
  storage.clear();
  for (const std::int32_t v : input.kept) {
    const auto point = frame.subspan(3 * at(v), 3);
    storage.insert(storage.end(), point.begin(), point.end());
  }
  return storage;
}

}  // namespace honeycomb::Cli
