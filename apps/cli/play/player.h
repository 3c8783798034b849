#pragma once

#include <memory>
#include <optional>
#include <string>

#include "apps/cli/play/backend_choice.h"
#include "apps/cli/play/background_work.h"
#include "apps/cli/play/clock.h"
#include "apps/cli/play/history.h"
#include "apps/cli/play/orbit.h"
#include "apps/cli/play/stage.h"

namespace honeycomb::Cli::Play {

/// What of the window is open.
struct Panels {
  bool options = true;
  bool graphs = true;
  bool help = false;
};

/// Everything about a playback that has nothing to do with a window or a device: what is played and how, where it is in
/// time, from where it is seen, what was measured. Belongs to one thread; surfaces are built on another.
class Player {
 public:
  /// Begins to build the request's surface. `turntable`: degrees the camera turns over the animation, if it does.
  Player(SurfaceRequest request, Appearance appearance, BackendChoice backend,
         BackgroundBuild::Build build = PlaySurface::build, std::optional<double> turntable = std::nullopt);

  /// Lets time pass and takes over what has been built. True where the surface is another one from now on.
  bool update(double seconds, float aspect);

  /// What is shown; null before the first is there.
  const std::shared_ptr<const PlaySurface>& surface() const { return surface_; }
  /// What is shown or being built.
  const SurfaceRequest& request() const { return request_; }
  /// Builds something else in the background; the surface stays until it is there, and for good where it has an error:
  /// then that is the message and the request is what it was.
  void change(SurfaceRequest request);
  /// The scheme of the last change, whatever came of it.
  const std::string& triedScheme() const { return triedScheme_; }
  /// Plays another file: a mesh, or a point cache for the mesh there is.
  void openFile(const std::string& path);
  bool building() const { return build_.busy(); }
  /// The error of the very first surface, without which there is nothing to play.
  const std::optional<Error>& failure() const { return failure_; }

  /// What refines the frames, and what came of it.
  void useBackend(const std::string& name);
  void stepBackend();
  /// The device was lost and made anew: frames are refined on the CPU from now on.
  void deviceLost();
  /// A backend had an error: tries the next one where it may. False where that was the only one.
  bool backendFailed(const Error& error);
  void report(const FrameReport& frame);
  void reportDifference(double ulps) { histories.difference.add(static_cast<float>(ulps)); }

  /// From where the frame is seen, its turntable included.
  Orbit view() const;
  void frameAll();
  /// Moves the camera, see Orbit.
  std::optional<Orbit>& orbit() { return orbit_; }

  void say(std::string message);
  const std::string& message() const { return message_; }
  /// The user goes on: a message that could be seen by now goes.
  void dismissMessage();
  /// Seconds since the message.
  double messageAge() const { return messageAge_; }

  /// The option of the scheme that keys change; null where it has none.
  const SchemeOption* chosenOption() const;
  void chooseNextOption() { ++chosenOption_; }

  PlayClock clock{1, 24};
  Appearance appearance;
  BackendChoice backend;
  Panels panels;
  Histories histories;
  bool comparing = false;
  bool awaited = false;  ///< the backend, whose tables are being brought while another refines
  bool screenshotWanted = false;
  bool quit = false;

 private:
  void take(BackgroundBuild::Outcome outcome);

  SurfaceRequest request_;
  SurfaceRequest shown_;
  std::string triedScheme_;
  std::optional<double> turntable_;
  std::shared_ptr<const PlaySurface> surface_;
  std::optional<Orbit> orbit_;
  std::optional<Error> failure_;
  std::string message_;
  double messageAge_ = 0;
  std::size_t chosenOption_ = 0;
  float aspect_ = 1;
  BackgroundBuild build_;
};

}  // namespace honeycomb::Cli::Play
