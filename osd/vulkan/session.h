#pragma once

#include <span>

#include "osd/vulkan/frame_slot.h"

namespace honeycomb::Osd {

/// Control points in, refined points and limits out, one frame and then another: for those who don't record commands
/// themselves and want each result at once. A frame is one submit and one wait, and allocates nothing. VulkanFrames has
/// several on their way; a session needs no feature of the device.
///
/// Uses the device's queue, which nobody else may use during create() and run() unless there is a
/// VulkanDevice::queueLock. Belongs to one thread at a time.
class VulkanSession {
 public:
  /// Errors: as of VulkanEvaluator::upload and bind, and deviceLost.
  static Result<VulkanSession> create(VulkanEvaluator& evaluator, const Far::Refinement& refinement,
                                      const VulkanTableOptions& options = {});
  /// Of `options` the binding's timing is heeded.
  static Result<VulkanSession> create(const VulkanEvaluator& evaluator, const VulkanTable& table,
                                      const VulkanBindingOptions& options = {});

  /// The control points of the next frame, laid out by options.control; write them before run().
  std::span<float> control() { return slot_.numbers(PointBuffer::control); }
  /// Evaluates: submits and waits. Errors: deviceLost, outOfMemory.
  Result<void> run();

  /// The results of the last frame, laid out by the table's options; empty when the table doesn't compute them.
  std::span<const float> refined() const { return slot_.numbers(PointBuffer::refined); }
  std::span<const float> vertexPositions() const { return slot_.numbers(PointBuffer::vertexPositions); }
  std::span<const float> vertexNormals() const { return slot_.numbers(PointBuffer::vertexNormals); }
  std::span<const float> facePositions() const { return slot_.numbers(PointBuffer::facePositions); }
  std::span<const float> faceNormals() const { return slot_.numbers(PointBuffer::faceNormals); }

  /// Copies the points in, evaluates, copies the refined points out. Both must have the sizes of control() and
  /// refined(): invalidOption otherwise.
  Result<void> refine(std::span<const float> points, std::span<float> refined);

  /// The results on the device, usable as storage and as vertex buffers, so that a renderer reads them in place. After
  /// run() they are visible to every stage of later submissions to the queue.
  VulkanRange range(PointBuffer points) const { return slot_.range(points); }

  const VulkanTable& table() const { return slot_.table(); }
  const VulkanBinding& binding() const { return slot_.binding(); }

 private:
  explicit VulkanSession(FrameSlot slot) : slot_(std::move(slot)) {}

  FrameSlot slot_;
};

}  // namespace honeycomb::Osd
