#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string_view>

#include "apps/viewer/picture.h"
#include "far/base/result.h"

namespace honeycomb::Cli::Play {

/// Is a path a video's, by its extension (.mp4, .webm, .mov, .mkv, .gif)?
bool isVideo(const std::filesystem::path& path);

/// A video that ffmpeg makes of pictures which it is given through a pipe. A file that was not finished is removed.
class VideoPipe {
 public:
  /// Is ffmpeg on the PATH? Errors: unsupported, saying what to do.
  static Result<void> available(const std::filesystem::path& output);
  /// Starts ffmpeg for pictures of that size. Errors: of available(); unwritable.
  static Result<VideoPipe> start(const std::filesystem::path& output, std::int32_t width, std::int32_t height,
                                 double framesPerSecond);
  VideoPipe(VideoPipe&& other) noexcept;
  VideoPipe& operator=(VideoPipe&&) = delete;
  ~VideoPipe();

  /// Errors: unwritable, where ffmpeg has given up.
  Result<void> write(const Viewer::Picture& picture);
  /// Waits until the file is there. Errors: unwritable, with ffmpeg's exit status.
  Result<void> finish();

 private:
  VideoPipe(std::filesystem::path output, pid_t child, int pipe)
      : output_(std::move(output)), child_(child), pipe_(pipe) {}
  int close();

  std::filesystem::path output_;
  pid_t child_ = -1;
  int pipe_ = -1;
};

}  // namespace honeycomb::Cli::Play
