#pragma once

#include <array>
#include <memory>
#include <span>

#include "osd/vulkan/commands.h"
#include "osd/vulkan/evaluator.h"

namespace honeycomb::Osd {

/// Control points in, refined points and limits out, frame after frame: for those who don't record commands themselves.
/// Owns the table, its buffers (mapped all the time) and a command buffer that is recorded once; a frame is one submit
/// and one wait, and allocates nothing.
///
/// Uses the device's queue, which nobody else may use during create() and run(). Belongs to one thread at a time.
class VulkanSession {
 public:
  /// Errors: as of VulkanEvaluator::upload and bind, and deviceLost.
  static Result<VulkanSession> create(VulkanEvaluator& evaluator, const Far::Refinement& refinement,
                                      const VulkanTableOptions& options = {});
  static Result<VulkanSession> create(const VulkanEvaluator& evaluator, VulkanTable table);

  /// The control points of the next frame, laid out by options.control; write them before run().
  std::span<float> control() { return numbers(PointBuffer::control); }
  /// Evaluates: submits and waits. Errors: deviceLost, outOfMemory.
  Result<void> run();

  /// The results of the last frame, laid out by the table's options; empty when the table doesn't compute them.
  std::span<const float> refined() const { return numbers(PointBuffer::refined); }
  std::span<const float> vertexPositions() const { return numbers(PointBuffer::vertexPositions); }
  std::span<const float> vertexNormals() const { return numbers(PointBuffer::vertexNormals); }
  std::span<const float> facePositions() const { return numbers(PointBuffer::facePositions); }
  std::span<const float> faceNormals() const { return numbers(PointBuffer::faceNormals); }

  /// Copies the points in, evaluates, copies the refined points out. Both must have the sizes of control() and
  /// refined(): invalidOption otherwise.
  Result<void> refine(std::span<const float> points, std::span<float> refined);

  /// The results on the device, usable as storage and as vertex buffers, so that a renderer reads them in place. After
  /// run() they are visible to every stage of later submissions to the queue.
  VulkanRange range(PointBuffer points) const { return buffer(points).range(); }

  const VulkanTable& table() const { return table_; }

 private:
  const SharedBuffer& buffer(PointBuffer points) const { return buffers_[static_cast<std::size_t>(points)]; }
  std::span<float> numbers(PointBuffer points) const {
    return buffer(points).numbers().first(table_.bytesOf(points) / sizeof(float));
  }
  Result<void> makeBuffers();
  Result<void> clearStaged();
  Result<void> record();
  void recordInput() const;
  void recordOutput() const;

  std::shared_ptr<const VulkanCore> core_;
  VulkanTable table_;
  std::array<SharedBuffer, kCallerBuffers> buffers_;
  std::unique_ptr<VulkanBinding> binding_;
  CommandRunner commands_;
};

}  // namespace honeycomb::Osd
