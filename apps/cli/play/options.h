#pragma once

#include <optional>
#include <string>

#include "apps/cli/console.h"
#include "apps/cli/play/backend_choice.h"
#include "apps/cli/play/stage.h"

namespace honeycomb::Cli::Play {

/// What the command line says, before it is looked at.
struct PlayCommand {
  SurfaceRequest request;
  bool headless = false;
  std::string output;  ///< empty: none
  std::string sheet;
  std::string size;
  std::optional<double> turntable;  ///< degrees over the clip
  std::string view = "cells";
  bool edges = false;  ///< whatever the view has
  bool noEdges = false;
  bool cage = false;
  bool normals = false;
  double seconds = 0;  ///< that the window stays open; 0: until it is closed
};

struct PictureSize {
  std::int32_t width = 1280;
  std::int32_t height = 800;
  float aspect() const { return static_cast<float>(width) / static_cast<float>(height); }
};

/// What the command line's words mean, with a window and without.
struct PlaySettings {
  Appearance appearance;
  PictureSize size;
  BackendChoice backend;
};

/// "1280x800". Errors: invalidOption.
Result<PictureSize> parseSize(const std::string& text);
/// Errors: invalidOption for an unknown view or backend, and for what is no size.
Result<PlaySettings> settingsOf(const PlayCommand& command);

/// Draws every frame without a window and writes pictures, a video, a contact sheet. Errors: everything's.
Result<void> playHeadless(const PlayCommand& command, const Session& session);
/// Opens the window and returns when it is closed. Errors: unsupported in builds without it; those of the input.
Result<void> playInWindow(const PlayCommand& command, const Session& session);

}  // namespace honeycomb::Cli::Play
