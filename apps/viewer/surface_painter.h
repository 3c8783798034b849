#pragma once

#include <memory>
#include <span>

#include "apps/viewer/renderer.h"
#include "far/tables/refinement.h"
#include "osd/vulkan/frames.h"

namespace honeycomb::Viewer {

/// Refines a deforming mesh on the device and draws it from the buffers the refinement left there: the refined points,
/// and the exact limit normals of their vertices. Belongs to one thread at a time.
class SurfacePainter {
 public:
  /// The refinement must have its limits (RefineOptions::limits). `device` must outlive the painter.
  /// Errors: those of Osd::VulkanEvaluator::upload, Osd::VulkanFrames::create and Renderer::create.
  static Result<SurfacePainter> create(const Osd::VulkanDevice& device, const Far::Refinement& refinement,
                                       const RendererOptions& options,
                                       const Osd::VulkanEvaluatorOptions& evaluation = {});

  /// Sends the control points of a frame off, 3 numbers each; pictures are drawn behind it on the device, without a
  /// wait here. Errors: invalidOption for another number of points; deviceLost.
  Result<void> pose(std::span<const float> control);
  /// The refined points of the last pose, waited for; empty before the first and when the device is lost.
  std::span<const float> points() const;
  Bounds bounds() const { return boundsOf(points()); }

  /// The last pose: its surface, or the control mesh it was refined from, whose faces are always faceted. Errors:
  /// invalidOption before the first pose; those of Renderer::draw.
  Result<Picture> surface(const View& view);
  Result<Picture> cage(const View& view);

 private:
  SurfacePainter(Osd::VulkanFrames frames, Renderer renderer, CellMesh cells, CellMesh cage);
  Result<PointSource> pointsOf(Osd::PointBuffer points) const;

  Osd::VulkanFrames frames_;
  Osd::VulkanTicket posed_;
  Renderer renderer_;
  CellMesh cells_;
  CellMesh cage_;
};

}  // namespace honeycomb::Viewer
