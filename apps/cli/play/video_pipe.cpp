#include "apps/cli/play/video_pipe.h"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <span>
#include <sstream>
#include <utility>
#include <vector>

namespace honeycomb::Cli::Play {
namespace {

constexpr std::array<std::string_view, 5> kVideos{".mp4", ".webm", ".mov", ".mkv", ".gif"};

bool onPath(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (access((std::filesystem::path(folder) / program).c_str(), X_OK) == 0) return true;
  return false;
}

/// Pictures come raw and leave with even sides, which most codecs want.
std::vector<std::string> commandLine(const std::filesystem::path& output, std::int32_t width, std::int32_t height,
                                     double framesPerSecond) {
  return {"ffmpeg",       "-y",
          "-loglevel",    "error",
          "-f",           "rawvideo",
          "-pix_fmt",     "rgba",
          "-s",           fmt::format("{}x{}", width, height),
          "-r",           fmt::format("{}", framesPerSecond),
          "-i",           "-",
          "-vf",          "pad=ceil(iw/2)*2:ceil(ih/2)*2",
          "-pix_fmt",     "yuv420p",
          output.string()};
}

/// Runs the program with the pipe's reading end as its standard input.
Result<pid_t> spawn(const std::vector<std::string>& arguments, const std::array<int, 2>& ends) {
  std::vector<char*> pointers;
  pointers.reserve(arguments.size() + 1);
  for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
  pid_t child = -1;
  const int failure = posix_spawnp(&child, pointers[0], &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) return fail(ErrorCode::unwritable, fmt::format("ffmpeg can't be run: {}", std::strerror(failure)));
  return child;
}

}  // namespace

bool isVideo(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return std::find(kVideos.begin(), kVideos.end(), extension) != kVideos.end();
}

Result<void> VideoPipe::available(const std::filesystem::path& output) {
  if (onPath("ffmpeg")) return {};
  return fail(ErrorCode::unsupported,
              fmt::format("{}: videos are made by ffmpeg, which isn't installed; install it, or "
                          "write pictures with --output frame_%04d.png",
                          output.string()));
}

Result<VideoPipe> VideoPipe::start(const std::filesystem::path& output, std::int32_t width, std::int32_t height,
                                   double framesPerSecond) {
  if (const auto there = available(output); !there) return tl::unexpected(there.error());
  std::array<int, 2> ends{};
  // A socket, which unlike a pipe can be written to without a signal where nobody reads any more.
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    return fail(ErrorCode::unwritable, fmt::format("{}: no pipe: {}", output.string(), std::strerror(errno)));
  const auto child = spawn(commandLine(output, width, height, framesPerSecond), ends);
  ::close(ends[0]);
  if (!child) {
    ::close(ends[1]);
    return tl::unexpected(child.error());
  }
  return VideoPipe(output, *child, ends[1]);
}

VideoPipe::VideoPipe(VideoPipe&& other) noexcept
    : output_(std::move(other.output_)),
      child_(std::exchange(other.child_, -1)),
      pipe_(std::exchange(other.pipe_, -1)) {}

VideoPipe::~VideoPipe() {
  if (child_ < 0) return;
  close();
  std::error_code ignored;
  std::filesystem::remove(output_, ignored);
}

int VideoPipe::close() {
  ::close(pipe_);
  int status = 0;
  while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
  }
  child_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

Result<void> VideoPipe::write(const Viewer::Picture& picture) {
  std::span<const std::uint8_t> rest = picture.rgba;
  while (!rest.empty()) {
    const ssize_t written = ::send(pipe_, rest.data(), rest.size(), MSG_NOSIGNAL);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0)
      return fail(ErrorCode::unwritable,
                  fmt::format("{}: ffmpeg takes no more pictures: {}", output_.string(), std::strerror(errno)));
    rest = rest.subspan(static_cast<std::size_t>(written));
  }
  return {};
}

Result<void> VideoPipe::finish() {
  const int status = close();
  if (status == 0) return {};
  std::error_code ignored;
  std::filesystem::remove(output_, ignored);
  return fail(ErrorCode::unwritable, fmt::format("{}: ffmpeg ended with status {}", output_.string(), status));
}

}  // namespace honeycomb::Cli::Play
