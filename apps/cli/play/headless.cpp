#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <glm/gtc/constants.hpp>

#include "apps/cli/formats.h"
#include "apps/cli/interrupt.h"
#include "apps/cli/json_text.h"
#include "apps/cli/play/backend_choice.h"
#include "apps/cli/play/device_levels.h"
#include "apps/cli/play/options.h"
#include "apps/cli/play/video_pipe.h"
#include "apps/cli/progress.h"
#include "apps/viewer/contact_sheet.h"
#include "far/base/stopwatch.h"
#include "io/frame_names.h"
#include "io/png.h"

namespace honeycomb::Cli::Play {
namespace {

constexpr double kDegreesAPicture = 5;  ///< of a turntable round a mesh that doesn't move
constexpr std::int32_t kSheetPictures = 12;
constexpr std::int32_t kSheetColumns = 4;
constexpr std::int32_t kSheetWidth = 480;  ///< pixels of one of its pictures

/// What the command asks for, with everything opened that it needs.
struct Show {
  const PlayCommand& command;
  Appearance appearance;
  PictureSize size;
  BackendChoice backend;
  std::shared_ptr<const PlaySurface> surface;
  Stage& stage;

  std::int32_t pictureCount() const {
    if (surface->moves() || !command.turntable) return surface->frameCount();
    return std::max(1, static_cast<std::int32_t>(std::lround(std::abs(*command.turntable) / kDegreesAPicture)));
  }
  std::int32_t frameOf(std::int32_t picture) const { return surface->moves() ? picture : 0; }
  /// In the file's name: the frame's, where there are frames.
  std::int32_t numberOf(std::int32_t picture) const {
    return surface->moves() || !command.turntable ? surface->frameNumber(picture) : picture;
  }
};

/// Sums over all pictures, milliseconds; of the last one's levels.
struct Times {
  double evaluate = 0, upload = 0, draw = 0, first = 0;
  std::vector<Osd::LevelTime> levels{};
};

Orbit cameraOf(const Show& show, std::int32_t picture) {
  const PlaySurface& surface = *show.surface;
  const float aspect = show.size.aspect();
  if (!show.command.turntable) return Orbit::framing(surface.outline(), surface.bounds(), aspect);
  Orbit orbit = Orbit::turntable(surface.outline(), surface.bounds(), aspect);
  const double turned = *show.command.turntable * picture / show.pictureCount();
  orbit.turn(static_cast<float>(glm::radians(turned)), 0);
  return orbit;
}

Result<void> pose(Show& show, std::int32_t frame, Times& times) {
  auto posed = show.stage.pose(show.backend.current(), frame);
  // A backend that was only tried may be missing.
  while (!posed && posed.error().code != ErrorCode::invalidPositions && show.backend.drop())
    posed = show.stage.pose(show.backend.current(), frame);
  if (!posed) return tl::unexpected(posed.error());
  show.backend.took(posed->evaluate + posed->upload);
  times.evaluate += posed->evaluate;
  times.upload += posed->upload;
  times.levels = std::move(posed->levels);
  return {};
}

Result<Viewer::Picture> draw(Show& show, const Orbit& orbit, std::int32_t picture, Times& times) {
  if (const auto posed = pose(show, show.frameOf(picture), times); !posed) return tl::unexpected(posed.error());
  const Stopwatch watch;
  auto drawn = show.stage.picture(show.appearance, orbit);
  times.draw += watch.milliseconds();
  return drawn;
}

Result<void> save(const std::filesystem::path& path, const Viewer::Picture& picture) {
  return Io::writePng(path, picture.width, picture.height, picture.rgba);
}

/// Where pictures go: files, or a video's pipe.
class Output {
 public:
  static Result<Output> open(const Show& show) {
    Output output;
    output.path_ = show.command.output;
    output.names_ = Io::FrameNames::parse(output.path_);
    if (!isVideo(output.path_)) {
      if (show.pictureCount() > 1 && !output.path_.empty() && !output.names_)
        return fail(ErrorCode::invalidOption,
                    fmt::format("{}: is one file for {} pictures; number them, as frame_%04d.png",
                                output.path_.string(), show.pictureCount()));
      return output;
    }
    auto video = VideoPipe::start(output.path_, show.size.width, show.size.height, show.surface->framesPerSecond());
    if (!video) return tl::unexpected(video.error());
    output.video_ = std::make_unique<VideoPipe>(std::move(*video));
    return output;
  }
  bool wanted() const { return !path_.empty(); }
  Result<void> write(std::int32_t number, const Viewer::Picture& picture) {
    if (video_) return video_->write(picture);
    return save(names_ ? (*names_)(number) : path_, picture);
  }
  Result<void> finish() { return video_ ? video_->finish() : Result<void>(); }

 private:
  std::filesystem::path path_;
  std::optional<Io::FrameNames> names_;
  std::unique_ptr<VideoPipe> video_;
};

Result<void> writePictures(Show& show, const Session& session, Times& times) {
  auto output = Output::open(show);
  if (!output) return tl::unexpected(output.error());
  if (!output->wanted()) return {};
  Progress progress(session, "drawing", "frames", show.pictureCount());
  const InterruptScope interruptible;
  for (std::int32_t i = 0; i < show.pictureCount(); ++i) {
    if (interruptSignal() != 0) return fail(ErrorCode::unwritable, "interrupted");
    const auto picture = draw(show, cameraOf(show, i), i, times);
    if (!picture) return tl::unexpected(picture.error());
    if (auto written = output->write(show.numberOf(i), *picture); !written) return written;
    progress.advance(1);
  }
  return output->finish();
}

/// Some of the pictures on one, smaller.
Result<void> writeSheet(Show& show, Times& times) {
  if (show.command.sheet.empty()) return {};
  const auto height = static_cast<std::int32_t>(std::lround(kSheetWidth / show.size.aspect()));
  if (auto sized = show.stage.renderer().resize(kSheetWidth, std::max(height, 1)); !sized) return sized;
  const std::int32_t count = std::min(kSheetPictures, show.pictureCount());
  std::vector<Viewer::Picture> pictures;
  for (std::int32_t i = 0; i < count; ++i) {
    const auto which = static_cast<std::int32_t>(std::int64_t{i} * show.pictureCount() / count);
    auto picture = draw(show, cameraOf(show, which), which, times);
    if (!picture) return tl::unexpected(picture.error());
    pictures.push_back(std::move(*picture));
  }
  Viewer::SheetLayout layout;
  layout.columns = kSheetColumns;
  return save(show.command.sheet, contactSheet(pictures, layout));
}

/// What can be told before anything is read.
Result<void> checkOutputs(const PlayCommand& command) {
  if (command.output.empty() && command.sheet.empty())
    return fail(ErrorCode::invalidOption,
                "--headless: say what to write: --output frame_%04d.png, --output FILE.mp4, or --sheet FILE.png");
  std::vector<std::filesystem::path> inputs{command.request.surface.input};
  if (!command.request.animation.cache.empty()) inputs.emplace_back(command.request.animation.cache);
  for (const std::string& name : {command.output, command.sheet}) {
    if (name.empty()) continue;
    const std::filesystem::path path(name);
    const bool video = name == command.output && isVideo(path);
    if (!video && path.extension() != ".png")
      return fail(ErrorCode::invalidOption,
                  fmt::format("{}: pictures are .png files, videos .mp4, .webm, .mov, .mkv or .gif", name));
    if (auto writable = checkOutput(path, inputs); !writable) return writable;
    if (video)
      if (auto there = VideoPipe::available(path); !there) return there;
  }
  return {};
}

Result<void> printSummary(const Show& show, const Session& session, const Times& times) {
  if (!session.json) {
    printNote(session, fmt::format("{}: {} at level {}", show.command.output, counted(show.pictureCount(), "picture"),
                                   show.surface->refinement().levelCount()));
    return {};
  }
  const double count = show.pictureCount();
  const nlohmann::ordered_json json{{"input", show.command.request.surface.input},
                                    {"output", show.command.output},
                                    {"device", show.stage.context().deviceName()},
                                    {"backend", show.backend.current()},
                                    {"pictures", show.pictureCount()},
                                    {"vertices", show.surface->refinement().last().topology.vertexCount()},
                                    {"build_ms", show.surface->buildMs()},
                                    {"evaluate_ms", times.evaluate / count},
                                    {"device_levels", deviceLevels(times.levels)},
                                    {"upload_ms", times.upload / count},
                                    {"draw_ms", times.draw / count}};
  return printResult(jsonText(json));
}

}  // namespace

Result<void> playHeadless(const PlayCommand& command, const Session& session) {
  if (auto sound = checkOutputs(command); !sound) return sound;
  auto settings = settingsOf(command);
  if (!settings) return tl::unexpected(settings.error());
  const PictureSize size = settings->size;
  // The device is opened while tables are built.
  auto building = std::async(std::launch::async, [&command] { return PlaySurface::build(command.request); });
  auto stage = Stage::open({.picture = {size.width, size.height}});
  const auto surface = building.get();
  if (!surface) return tl::unexpected(surface.error());
  if (!stage) return tl::unexpected(stage.error());
  printNotes(session, (*surface)->input());
  if (const auto shown = stage->show(*surface); !shown)
    return tl::unexpected(inFile((*surface)->file(), shown.error()));
  Show show{command, settings->appearance, size, std::move(settings->backend), *surface, *stage};
  Times times;
  if (auto written = writePictures(show, session, times); !written) return written;
  if (auto written = writeSheet(show, times); !written) return written;
  return printSummary(show, session, times);
}

}  // namespace honeycomb::Cli::Play
