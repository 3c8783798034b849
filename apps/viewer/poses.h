#pragma once

#include <span>
#include <vector>

#include "apps/viewer/bindings.h"
#include "far/tables/refinement.h"
#include "osd/vulkan/evaluator.h"
#include "osd/vulkan/frames.h"

namespace honeycomb::Viewer {

/// Where the points of a pose lie on the device.
struct PosedPoints {
  PointSource control;
  PointSource refined;
  PointSource normals;  ///< unit limit normals of the refined vertices
};

/// What a pose took, milliseconds.
struct PoseTimes {
  double evaluate = 0;
  double upload = 0;
  std::vector<Osd::LevelTime> levels{};  ///< of `evaluate`, by the device's own clock; empty where it doesn't refine
};

/// Refines a deforming mesh, pose after pose, and has the points on the device to draw from. Belongs to one thread at a
/// time.
class Poses {
 public:
  virtual ~Poses() = default;
  /// Takes the control points of a frame, 3 numbers each, and returns once they are refined. Nothing may still draw
  /// the pose before. Errors: invalidOption for another number of points; deviceLost.
  virtual Result<PoseTimes> pose(std::span<const float> control) = 0;
  /// The last pose. Errors: invalidOption before the first.
  virtual Result<PosedPoints> points() const = 0;
  /// Its refined points, x y z packed; empty before the first and when the device is lost.
  virtual std::span<const float> refined() const = 0;
};

struct DevicePosesOptions {
  bool normals = true;  ///< off where the refinement has no limits: the points stand in for the normals
  bool timing = false;  ///< fill PoseTimes::levels, where the device has timestamps
};

/// Refined on the device, drawn from the buffers the refinement left there.
class DevicePoses : public Poses {
 public:
  /// Normals are those of the refinement's limits (RefineOptions::limits). The evaluator's device must outlive this;
  /// its queue is used as by Osd::VulkanEvaluator::upload. Errors: those of that and of Osd::VulkanFrames::create.
  static Result<DevicePoses> create(Osd::VulkanEvaluator evaluator, const Far::Refinement& refinement,
                                    const DevicePosesOptions& options = {});

  Result<PoseTimes> pose(std::span<const float> control) override;
  Result<PosedPoints> points() const override;
  std::span<const float> refined() const override;

  /// pose() without the wait: pictures are drawn behind it on the device.
  Result<void> send(std::span<const float> control);

 private:
  DevicePoses(Osd::VulkanFrames frames, std::size_t controlNumbers, bool normals, bool timing)
      : frames_(std::move(frames)), controlNumbers_(controlNumbers), normals_(normals), timing_(timing) {}

  Osd::VulkanFrames frames_;
  Osd::VulkanTicket posed_;
  std::size_t controlNumbers_;
  bool normals_;
  bool timing_;
};

}  // namespace honeycomb::Viewer
