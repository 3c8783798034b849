#pragma once

#include <memory>
#include <optional>

#include "apps/cli/play/backend_loader.h"
#include "apps/cli/play/options.h"
#include "apps/cli/play/player.h"
#include "apps/cli/play/surface_loader.h"
#include "apps/cli/play/window/input.h"
#include "apps/cli/play/window/interface.h"
#include "apps/cli/play/window/screen.h"
#include "far/base/stopwatch.h"

namespace honeycomb::Cli::Play {

/// The library that makes windows, and one of them.
class WindowHandle {
 public:
  /// Errors: unsupported where there is no display.
  static Result<WindowHandle> open(const PictureSize& size, const std::string& title);
  ~WindowHandle();
  WindowHandle(WindowHandle&& other) noexcept;
  WindowHandle& operator=(WindowHandle&&) = delete;
  GLFWwindow* get() const { return window_; }

 private:
  explicit WindowHandle(GLFWwindow* window) : window_(window) {}
  GLFWwindow* window_ = nullptr;
};

/// What was measured while a window was open.
struct WindowSummary {
  std::int64_t frames = 0;
  double seconds = 0;         ///< since the first picture
  double firstPictureMs = 0;  ///< from the command
  double longestGapMs = 0;    ///< between two pictures
};

/// A window that shows a player, and the device it draws with. Belongs to the main thread.
class Window {
 public:
  /// `loader` is what the player's surfaces are built by; both outlive the window.
  Window(WindowHandle handle, Player& player, SurfaceLoader& loader, std::string pictureNames);
  ~Window();

  /// Until it is closed, the player quits, or `seconds` (0: any time) have passed since the first picture.
  /// Errors: of the first surface and of the device; later ones are shown.
  Result<WindowSummary> run(double seconds);
  const std::string& deviceName() const { return facts_.device; }

 private:
  /// What the last picture was of; where nothing of it changes there is no need to draw it again.
  struct Drawn {
    const PlaySurface* surface = nullptr;
    std::int32_t frame = -1;
    std::string backend;
    Appearance appearance;
    Viewer::Lighting lighting = Viewer::Lighting::quick;
    glm::vec3 eye{0};
    glm::vec3 target{0};
    VkExtent2D size{};
    bool operator==(const Drawn& other) const;
  };

  Result<void> openDevice();
  void closeDevice();
  Result<void> frame(double seconds);
  Result<void> takeSurface();
  Result<void> fitSize();
  /// The backend that is asked for once it is ready, until then what refined before.
  Result<std::string> refiningBackend();
  Result<void> compare(std::int32_t frame);
  Result<void> pose();
  Result<void> draw();
  Result<void> recover(const Error& error);
  void writePicture();
  Drawn wanted() const;
  float aspect() const;
  bool still() const;

  WindowHandle handle_;
  Player& player_;
  SurfaceLoader& loader_;
  WindowInput input_;
  InterfaceContext interface_;
  std::optional<Stage> stage_;
  std::optional<Screen> screen_;
  std::optional<BackendLoader> backends_;
  InterfaceFacts facts_;
  std::string pictureNames_;
  Drawn drawn_;
  std::int32_t posedFrame_ = -1;
  std::string posedBackend_;
  Viewer::PoseTimes posed_;
  bool newPose_ = false;
  double unchanged_ = 0;  ///< seconds that the camera and the frame have stood still
  Drawn seen_;
  bool everDrawn_ = false;
  Stopwatch sinceCommand_;
  Stopwatch sinceShown_;
  WindowSummary summary_;
};

}  // namespace honeycomb::Cli::Play
