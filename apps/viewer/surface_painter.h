#pragma once

#include <memory>
#include <span>

#include "apps/viewer/poses.h"
#include "apps/viewer/renderer.h"
#include "far/tables/refinement.h"

namespace honeycomb::Viewer {

/// Refines a deforming mesh on the device and draws it from the buffers the refinement left there: the refined points,
/// and the exact limit normals of their vertices. Belongs to one thread at a time.
class SurfacePainter {
 public:
  /// The refinement must have its limits (RefineOptions::limits). `device` must outlive the painter.
  /// Errors: those of Osd::VulkanEvaluator::create, DevicePoses::create and Renderer::create.
  static Result<SurfacePainter> create(const Osd::VulkanDevice& device, const Far::Refinement& refinement,
                                       const RendererOptions& options,
                                       const Osd::VulkanEvaluatorOptions& evaluation = {});

  /// Sends the control points of a frame off, 3 numbers each; pictures are drawn behind it on the device, without a
  /// wait here. Errors: invalidOption for another number of points; deviceLost.
  Result<void> pose(std::span<const float> control) { return poses_.send(control); }
  /// The refined points of the last pose, waited for; empty before the first and when the device is lost.
  std::span<const float> points() const { return poses_.refined(); }
  Bounds bounds() const { return boundsOf(points()); }

  /// The last pose: its surface, or the control mesh it was refined from, whose faces are always faceted. Errors:
  /// invalidOption before the first pose; those of Renderer::draw.
  Result<Picture> surface(const View& view);
  Result<Picture> cage(const View& view);

 private:
  SurfacePainter(DevicePoses poses, Renderer renderer, CellMesh cells, CellMesh cage);

  DevicePoses poses_;
  Renderer renderer_;
  CellMesh cells_;
  CellMesh cage_;
};

}  // namespace honeycomb::Viewer
