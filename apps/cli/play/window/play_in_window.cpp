#include <fmt/format.h>

#include <utility>

#include "apps/cli/json_text.h"
#include "apps/cli/play/device_levels.h"
#include "apps/cli/play/window/glfw.h"
#include "apps/cli/play/window/window.h"

namespace honeycomb::Cli::Play {
namespace {

std::string glfwProblem() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text != nullptr ? text : "no reason given";
}

}  // namespace

Result<WindowHandle> WindowHandle::open(const PictureSize& size, const std::string& title) {
  if (glfwInit() == GLFW_FALSE)
    return fail(ErrorCode::unsupported, fmt::format("no window can be opened here ({}); write pictures with --headless "
                                                    "--output frame_%04d.png",
                                                    glfwProblem()));
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  GLFWwindow* window = glfwCreateWindow(size.width, size.height, title.c_str(), nullptr, nullptr);
  if (window != nullptr) return WindowHandle(window);
  const std::string problem = glfwProblem();
  glfwTerminate();
  return fail(ErrorCode::unsupported, fmt::format("no window of {} x {} can be opened ({}); write pictures with "
                                                  "--headless --output frame_%04d.png",
                                                  size.width, size.height, problem));
}

WindowHandle::WindowHandle(WindowHandle&& other) noexcept : window_(std::exchange(other.window_, nullptr)) {}

WindowHandle::~WindowHandle() {
  if (window_ == nullptr) return;
  glfwDestroyWindow(window_);
  glfwTerminate();
}

Result<void> playInWindow(const PlayCommand& command, const Session& session) {
  auto settings = settingsOf(command);
  if (!settings) return tl::unexpected(settings.error());
  SurfaceLoader loader;
  Player player(
      command.request, settings->appearance, std::move(settings->backend),
      [&loader](const SurfaceRequest& request) { return loader.build(request); }, command.turntable);
  auto handle = WindowHandle::open(settings->size, "Honeycomb: " + command.request.surface.input);
  if (!handle) return tl::unexpected(handle.error());
  Window window(std::move(*handle), player, loader, command.output.empty() ? "honeycomb_%04d.png" : command.output);
  const auto summary = window.run(command.seconds);
  if (!summary) return tl::unexpected(summary.error());
  if (!session.json) return {};
  return printResult(jsonText({{"input", player.request().surface.input},
                               {"device", window.deviceName()},
                               {"backend", player.backend.current()},
                               {"frames", summary->frames},
                               {"seconds", summary->seconds},
                               {"frames_per_second", static_cast<double>(summary->frames) / summary->seconds},
                               {"first_picture_ms", summary->firstPictureMs},
                               {"longest_gap_ms", summary->longestGapMs},
                               {"evaluate_ms", player.histories.evaluate.median()},
                               {"device_levels", deviceLevels(player.histories.levels)},
                               {"upload_ms", player.histories.upload.median()},
                               {"draw_ms", player.histories.draw.median()}}));
}

}  // namespace honeycomb::Cli::Play
