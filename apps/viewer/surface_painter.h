#pragma once

#include <memory>
#include <span>

#include "apps/viewer/renderer.h"
#include "far/tables/refinement.h"
#include "osd/vulkan/session.h"

namespace honeycomb::Viewer {

/// Refines a deforming mesh on the device and draws it from the buffers the refinement left there: the refined points,
/// and the exact limit normals of their vertices. Belongs to one thread at a time.
class SurfacePainter {
 public:
  /// The refinement must have its limits (RefineOptions::limits). `device` must outlive the painter.
  /// Errors: those of Osd::VulkanSession::create and Renderer::create.
  static Result<SurfacePainter> create(const Osd::VulkanDevice& device, const Far::Refinement& refinement,
                                       const RendererOptions& options);

  /// Refines the control points of a frame, 3 numbers each. Errors: invalidOption for another number of points;
  /// deviceLost.
  Result<void> pose(std::span<const float> control);
  /// Of the refined points of the last pose.
  Bounds bounds() const { return boundsOf(session_.refined()); }
  std::span<const float> points() const { return session_.refined(); }

  /// The last pose: its surface, or the control mesh it was refined from, whose faces are always faceted.
  Result<Picture> surface(const View& view);
  Result<Picture> cage(const View& view);

 private:
  SurfacePainter(Osd::VulkanSession session, Renderer renderer, CellMesh cells, CellMesh cage);

  Osd::VulkanSession session_;
  Renderer renderer_;
  CellMesh cells_;
  CellMesh cage_;
};

}  // namespace honeycomb::Viewer
