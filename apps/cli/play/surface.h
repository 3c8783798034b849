#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/cli/animation_input.h"
#include "apps/cli/central_points.h"
#include "apps/cli/frame_control.h"
#include "apps/cli/surface_options.h"
#include "apps/viewer/camera.h"

namespace honeycomb::Cli::Play {

/// What is to be played: a value, so that a window's thread changes its own while another builds.
struct SurfaceRequest {
  SurfaceOptions surface;
  AnimationOptions animation;
};

/// A mesh, its animation and its tables: everything that playing needs and that no device has to do with. Immutable.
class PlaySurface {
 public:
  /// Reads the files and builds the tables. Errors: whatever is wrong with them.
  static Result<std::shared_ptr<const PlaySurface>> build(const SurfaceRequest& request);

  const Far::Refinement& refinement() const { return *refinement_; }
  /// Frames of the animation; one where nothing moves.
  std::int32_t frameCount() const { return animation_ ? animation_->range.count() : 1; }
  /// Number in the animation of a frame that is played, both from 0.
  std::int32_t frameNumber(std::int32_t frame) const { return animation_ ? animation_->range.begin + frame : 0; }
  bool moves() const { return frameCount() > 1; }
  double framesPerSecond() const;
  /// Are limit normals known? Without them cells are shaded by their own.
  bool hasNormals() const { return plan_.limits; }

  /// Control points of a frame, 0 .. frameCount()-1: vertices, then central control vertices where they are given.
  /// Thread-safe with a storage of one's own. Errors: those of the animation.
  Result<std::span<const float>> control(std::int32_t frame, FrameStorage& storage) const;
  /// The error with the file and the frame in front.
  Error ofFrame(std::int32_t frame, Error error) const;

  /// Refined points of some frames, spread over the animation: what a camera has to hold.
  const std::vector<float>& outline() const { return outline_; }
  /// Of these frames, all their points.
  const Viewer::Bounds& bounds() const { return bounds_; }
  const std::string& file() const { return plan_.mesh.input.file; }
  /// What of it was left out or changed, see printNotes.
  const MeshInput& input() const { return plan_.mesh.input; }
  double buildMs() const { return buildMs_; }

 private:
  explicit PlaySurface(SurfacePlan plan) : plan_(std::move(plan)) {}
  Result<void> readInput(const SurfaceRequest& request);
  Result<void> measure();

  SurfacePlan plan_;
  std::optional<Animation> animation_;
  CentralPoints central_;
  std::optional<Far::Refinement> refinement_;
  std::vector<float> outline_;
  Viewer::Bounds bounds_;
  double buildMs_ = 0;
};

}  // namespace honeycomb::Cli::Play
