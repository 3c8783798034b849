#pragma once

#include <memory>
#include <span>

#include "apps/viewer/bindings.h"
#include "apps/viewer/camera.h"
#include "apps/viewer/cell_mesh.h"
#include "apps/viewer/picture.h"
#include "apps/viewer/style.h"
#include "far/base/result.h"
#include "osd/vulkan/device.h"

namespace honeycomb::Viewer {

struct RendererOptions {
  std::int32_t width = 1600;  ///< pixels, 1 to the device's limit
  std::int32_t height = 1000;
};

/// What a picture shows, and from where.
struct View {
  Camera camera;
  Bounds bounds;  ///< of the points: lights, shadows and the ground are arranged round it
  Style style;
};

/// Draws meshes off screen with Vulkan: four samples a pixel, soft shadows, cell edges of constant width.
///
/// Points and unit normals are pulled straight from the buffers a compute evaluator wrote on the same queue, without a
/// copy; the renderer records the barrier from those writes to its reads. One renderer belongs to one thread at a time.
class Renderer {
 public:
  /// `device` must outlive the renderer and everything it uploads; its queue must support graphics.
  /// Errors: invalidOption for a size out of the device's range, unsupported, outOfMemory.
  static Result<Renderer> create(const Osd::VulkanDevice& device, const RendererOptions& options = {});
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;
  ~Renderer();

  /// Connectivity, once per mesh. It can be drawn by any renderer on the same device.
  Result<CellMesh> upload(const CellMeshContent& content) const;
  /// Points that come from the host, as a buffer to draw from.
  Result<Buffer> uploadPoints(std::span<const float> points) const;

  /// Submits, waits and returns the picture. Both point buffers hold mesh.vertexCount points.
  /// Errors: tooLarge when points lie past what the device can bind; deviceLost; outOfMemory.
  Result<Picture> draw(const CellMesh& mesh, const PointSource& positions, const PointSource& normals,
                       const View& view);

 private:
  struct State;
  explicit Renderer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace honeycomb::Viewer
