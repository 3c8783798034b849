#include "apps/cli/play/window/window.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>

#include <algorithm>
#include <utility>

#include "apps/cli/play/comparison.h"
#include "apps/cli/play/window/glfw.h"
#include "io/frame_names.h"
#include "io/png.h"

namespace honeycomb::Cli::Play {
namespace {

constexpr double kStillSeconds = 0.25;  ///< until a standing picture gets all its light
constexpr double kIdleSeconds = 0.04;   ///< between looks at a window that nothing happens in
constexpr double kLongestStep = 0.5;    ///< time that passes for the animation in one frame, at most
constexpr std::int64_t kMostPictures = 100000;

StageOptions stageOptions(VkExtent2D size) {
  StageOptions options;
  std::uint32_t count = 0;
  const char** names = glfwGetRequiredInstanceExtensions(&count);
  options.context.instanceExtensions.assign(names, names + count);
  options.context.deviceExtensions = {"VK_KHR_swapchain"};
  options.picture = {static_cast<std::int32_t>(size.width), static_cast<std::int32_t>(size.height),
                     kWindowPictureFormat};
  return options;
}

VkExtent2D framebufferOf(GLFWwindow* window) {
  int width = 0;
  int height = 0;
  glfwGetFramebufferSize(window, &width, &height);
  return {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
}

bool sameSize(VkExtent2D a, VkExtent2D b) {
  return a.width == b.width && a.height == b.height;
}

/// What refines while there is no other picture to look at: nothing that a device first compiles.
std::string soonest(const std::string& wanted) {
  return wanted == kDeviceBackend ? "tbb" : wanted;
}

bool sameLook(const Appearance& a, const Appearance& b) {
  return a.look == b.look && a.edges == b.edges && a.cage == b.cage && a.normals == b.normals;
}

}  // namespace

bool Window::Drawn::operator==(const Drawn& other) const {
  return surface == other.surface && frame == other.frame && backend == other.backend &&
         sameLook(appearance, other.appearance) && lighting == other.lighting && eye == other.eye &&
         target == other.target && sameSize(size, other.size);
}

Window::Window(WindowHandle handle, Player& player, SurfaceLoader& loader, std::string pictureNames)
    : handle_(std::move(handle)),
      player_(player),
      loader_(loader),
      input_(handle_.get(), player),
      interface_(handle_.get()),
      pictureNames_(std::move(pictureNames)) {}

Window::~Window() {
  closeDevice();
}

void Window::closeDevice() {
  loader_.useStage(nullptr);
  backends_.reset();
  screen_.reset();
  stage_.reset();
}

Result<void> Window::openDevice() {
  closeDevice();
  auto stage = Stage::open(stageOptions(framebufferOf(handle_.get())));
  if (!stage) return tl::unexpected(stage.error());
  stage_.emplace(std::move(*stage));
  auto screen = Screen::create(handle_.get(), stage_->context().device());
  if (!screen) return tl::unexpected(screen.error());
  screen_.emplace(std::move(*screen));
  loader_.useStage(&*stage_);
  backends_.emplace(*stage_);
  facts_.device = stage_->context().deviceName();
  everDrawn_ = false;
  return {};
}

Result<WindowSummary> Window::run(double seconds) {
  if (const auto opened = openDevice(); !opened) return tl::unexpected(opened.error());
  Stopwatch lap;
  Stopwatch open;
  while (glfwWindowShouldClose(handle_.get()) == GLFW_FALSE && !player_.quit) {
    if (still())
      glfwWaitEventsTimeout(kIdleSeconds);
    else
      glfwPollEvents();
    const double passed = std::min(lap.lap() / 1000, kLongestStep);
    Result<void> shown = frame(passed);
    if (!shown && shown.error().code == ErrorCode::deviceLost) shown = recover(shown.error());
    if (!shown) return tl::unexpected(shown.error());
    if (summary_.frames == 1) {
      summary_.firstPictureMs = sinceCommand_.milliseconds();
      open = Stopwatch();
    }
    if (seconds > 0 && summary_.frames > 0 && open.milliseconds() > 1000 * seconds) break;
  }
  summary_.seconds = open.milliseconds() / 1000;
  // What is still being built is waited for, but not by the user.
  glfwHideWindow(handle_.get());
  return summary_;
}

bool Window::still() const {
  return !player_.surface() || (everDrawn_ && wanted() == drawn_ && !player_.building() && !player_.clock.playing());
}

float Window::aspect() const {
  const VkExtent2D size = framebufferOf(handle_.get());
  return static_cast<float>(std::max(size.width, 1u)) / static_cast<float>(std::max(size.height, 1u));
}

Result<void> Window::takeSurface() {
  if (auto finished = screen_->finishFrame(); !finished) return finished;
  posedFrame_ = -1;
  auto loaded = loader_.take(*player_.surface());
  if (!loaded) return stage_->show(player_.surface());
  stage_->show(std::move(*loaded));
  return {};
}

Result<void> Window::fitSize() {
  const VkExtent2D size = framebufferOf(handle_.get());
  if (sameSize(size, screen_->extent()) && sameSize(size, stage_->renderer().extent())) return {};
  if (auto resized = screen_->resize(); !resized) return resized;
  const VkExtent2D now = screen_->extent();
  everDrawn_ = false;
  return stage_->renderer().resize(static_cast<std::int32_t>(now.width), static_cast<std::int32_t>(now.height));
}

Result<void> Window::frame(double seconds) {
  // Minimized.
  const VkExtent2D size = framebufferOf(handle_.get());
  if (size.width == 0 || size.height == 0) return {};
  const std::string next = player_.backend.first();
  loader_.expect({{player_.surface() ? next : soonest(next)}, stage_->colouring()});
  if (player_.update(seconds, aspect()))
    if (auto taken = takeSurface(); !taken) return taken;
  if (player_.failure()) return tl::unexpected(*player_.failure());
  if (!player_.surface()) return {};
  if (auto fitted = fitSize(); !fitted) return fitted;
  if (auto posed = pose(); !posed) return posed;
  const Drawn now = wanted();
  Drawn moved = seen_;
  moved.lighting = now.lighting;
  unchanged_ = now == moved ? unchanged_ + seconds : 0;
  seen_ = now;
  if (player_.screenshotWanted) writePicture();
  return draw();
}

Result<std::string> Window::refiningBackend() {
  if (stage_->readyBackend().empty()) return soonest(player_.backend.current());
  auto ready = backends_->ready(player_.backend.current());
  while (!ready && ready.error().code != ErrorCode::deviceLost && player_.backendFailed(ready.error()))
    ready = backends_->ready(player_.backend.current());
  if (!ready) return tl::unexpected(ready.error());
  if (*ready) return player_.backend.current();
  return stage_->refinesBy(posedBackend_) ? posedBackend_ : stage_->readyBackend();
}

Result<void> Window::compare(std::int32_t frame) {
  for (const char* backend : kComparedBackends) {
    const auto ready = backends_->ready(backend);
    if (ready && !*ready) return {};
    if (ready) continue;
    if (ready.error().code == ErrorCode::deviceLost) return tl::unexpected(ready.error());
    player_.comparing = false;
    player_.say(ready.error().message);
    return {};
  }
  const auto difference = largestDifference(*stage_, frame);
  if (difference) player_.reportDifference(*difference);
  if (!difference && difference.error().code == ErrorCode::deviceLost) return tl::unexpected(difference.error());
  return {};
}

Result<void> Window::pose() {
  const auto refining = refiningBackend();
  if (!refining) return tl::unexpected(refining.error());
  std::string backend = *refining;
  const std::int32_t frame = player_.clock.frame();
  player_.awaited = backend != player_.backend.current();
  newPose_ = frame != posedFrame_ || backend != posedBackend_;
  if (!newPose_) return {};
  if (player_.comparing)
    if (auto compared = compare(frame); !compared) return compared;
  auto posed = stage_->pose(backend, frame);
  while (!posed && posed.error().code != ErrorCode::deviceLost && player_.backendFailed(posed.error())) {
    backend = player_.backend.current();
    posed = stage_->pose(backend, frame);
  }
  if (!posed) return tl::unexpected(posed.error());
  posed_ = std::move(*posed);
  posedFrame_ = frame;
  posedBackend_ = backend;
  if (Viewer::looks()[player_.appearance.look].flatness)
    facts_.bend = Viewer::flatness(stage_->surface().refinement().last().topology, stage_->refined());
  return {};
}

Window::Drawn Window::wanted() const {
  const Viewer::Camera camera = player_.view().camera();
  Drawn wanted{player_.surface().get(), player_.clock.frame(),       posedBackend_,
               player_.appearance,      Viewer::Lighting::quick,     camera.eye,
               camera.target,           framebufferOf(handle_.get())};
  if (unchanged_ > kStillSeconds && !player_.clock.playing()) wanted.lighting = Viewer::Lighting::full;
  return wanted;
}

Result<void> Window::draw() {
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
  const Histories& took = player_.histories;
  const double frameMs = static_cast<double>(took.evaluate.median() + took.upload.median() + took.draw.median());
  facts_.framesPerSecond = frameMs > 0 ? 1000 / frameMs : 0;
  layOutInterface(player_, facts_);
  ImGui::Render();
  const Drawn now = wanted();
  Screen::Record record;
  const Stopwatch watch;
  if (!everDrawn_ || !(now == drawn_)) {
    const auto subject = stage_->subject(player_.appearance);
    if (!subject) return tl::unexpected(subject.error());
    Viewer::View view = stage_->view(player_.appearance, player_.view());
    view.style.lighting = now.lighting;
    record = [this, subject, view](VkCommandBuffer commands) {
      return stage_->renderer().record(commands, *subject, view);
    };
  }
  const auto shown = screen_->show(stage_->renderer().image(), record);
  if (!shown) return tl::unexpected(shown.error());
  if (auto finished = screen_->finishFrame(); !finished) return finished;
  if (!*shown) return screen_->resize();
  everDrawn_ = true;
  drawn_ = now;
  const double gap = sinceShown_.lap();
  if (summary_.frames > 0) summary_.longestGapMs = std::max(summary_.longestGapMs, gap);
  if (newPose_ || summary_.frames == 0) ++summary_.frames;
  if (newPose_ && !player_.awaited)
    player_.report({posed_.evaluate, posed_.upload, watch.milliseconds(), posed_.levels});
  return {};
}

Result<void> Window::recover(const Error& error) {
  if (const auto opened = openDevice(); !opened)
    return fail(ErrorCode::deviceLost, error.message + "; it can't be opened again: " + opened.error().message);
  player_.deviceLost();
  return player_.surface() ? takeSurface() : Result<void>();
}

void Window::writePicture() {
  player_.screenshotWanted = false;
  const auto names = Io::FrameNames::parse(pictureNames_);
  std::filesystem::path path = pictureNames_;
  for (std::int64_t i = 0; names && i < kMostPictures; ++i) {
    path = (*names)(i);
    if (!std::filesystem::exists(path)) break;
  }
  const auto picture = stage_->picture(player_.appearance, player_.view());
  everDrawn_ = false;
  if (!picture) return player_.say(picture.error().message);
  const auto written = Io::writePng(path, picture->width, picture->height, picture->rgba);
  player_.say(written ? "wrote " + path.string() : written.error().message);
}

}  // namespace honeycomb::Cli::Play
