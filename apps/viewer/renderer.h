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
  /// VK_FORMAT_R8G8B8A8_SRGB, or VK_FORMAT_B8G8R8A8_SRGB where the picture is to be copied into a window's image of
  /// that order.
  VkFormat colour = VK_FORMAT_R8G8B8A8_SRGB;
};

/// What a picture shows. Both buffers of points hold mesh.vertexCount points.
struct Subject {
  const CellMesh& mesh;
  PointSource positions;
  PointSource normals;             ///< unit; any numbers where faces are shaded by their own
  const LineMesh* cage = nullptr;  ///< lines drawn over it, faintly where they are behind it
  PointSource cagePoints{};
  bool spikes = false;  ///< show the normals
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

  Result<LineMesh> upload(std::int32_t vertexCount, std::span<const std::int32_t> pairs) const;
  /// Other colours for the faces of a mesh, one each; nothing that draws it may be running.
  static void recolour(CellMesh& mesh, std::span<const std::uint32_t> faceColours);

  /// Submits, waits and returns the picture.
  /// Errors: tooLarge when points lie past what the device can bind; deviceLost; outOfMemory.
  Result<Picture> draw(const Subject& subject, const View& view);
  Result<Picture> draw(const CellMesh& mesh, const PointSource& positions, const PointSource& normals,
                       const View& view) {
    return draw({mesh, positions, normals}, view);
  }

  /// Records the same picture into the caller's command buffer, outside a render pass; it ends up in image(), in
  /// VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL and visible to copies. Nothing that was recorded before may still be running.
  /// Errors: tooLarge.
  Result<void> record(VkCommandBuffer commands, const Subject& subject, const View& view);
  VkImage image() const;
  VkExtent2D extent() const;
  /// Pictures of another size from now on; nothing may be running. Errors: as of create.
  Result<void> resize(std::int32_t width, std::int32_t height);

 private:
  struct State;
  explicit Renderer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace honeycomb::Viewer
