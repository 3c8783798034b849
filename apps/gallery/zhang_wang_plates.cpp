#include "apps/gallery/plates.h"
#include "apps/gallery/sheet.h"
#include "far/schemes/zhang_wang.h"

namespace honeycomb::Gallery {
namespace {

using Device = Osd::VulkanDevice;

constexpr Viewer::RendererOptions kTile{270, 252};

Result<Model> afterSteps(const Shape& shape, std::int32_t levels, const Far::ZhangWangOptions& options = {}) {
  const auto topology = Far::Topology::create(shape.polygons);
  if (!topology) return tl::unexpected(topology.error());
  return refined(shape, Far::zhangWang(*topology, levels, options));
}

Result<Viewer::Picture> dodecagon(const Device& device) {
  Sheet sheet(device, kTile, 4);
  const auto addRow = [&](const Shape& shape, glm::vec3 side) {
    sheet.frame(shape.points, side);
    for (std::int32_t levels = 0; levels <= 3; ++levels) sheet.add(afterSteps(shape, levels));
  };
  addRow(dodecahedron(), {0.45F, 0.42F, 1.0F});
  addRow(ringed(12), {0, 1, 0});
  return sheet.finish();
}

Result<Viewer::Picture> vertexPull(const Device& device) {
  const Shape shape = cube();
  Sheet sheet(device, kTile, 3);
  sheet.frame(shape.points, {0.5F, 0.45F, 1.0F});
  sheet.add(afterSteps(shape, 0));
  for (const double c : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    Far::ZhangWangOptions options;
    options.vertexPull = c;
    sheet.add(afterSteps(shape, 5, options));
  }
  return sheet.finish();
}

constexpr Plate kPlates[] = {
    {"zhang_wang_dodecagon", "Honeycomb subdivision of a dodecagon",
     "After Zhang H.-X., Wang G.-J., *Honeycomb Subdivision*, Figure 5; a_n = (4 - cos(2 pi/n))/9, b_n = "
     "2/3 as printed, levels 0 to 3. The paper says dodecagon and does not describe the figure. Above the "
     "solid with twelve faces, the dodecahedron; below a polygon of twelve sides in the plane with a ring "
     "of quads round it: each step turns it by half a corner (Figure 4) and scales it by b_n cos(pi/12) = "
     "0.644. The border follows the paper's eq 16.",
     dodecagon},
    {"zhang_wang_c_n", "The cube with c_n from 0 to 1",
     "After Zhang H.-X., Wang G.-J., *Honeycomb Subdivision*, Figure 6. A cube, and its mesh after five "
     "steps with c_n = 0, 0.25; 0.5, 0.75, 1; a_n and b_n as above, central control vertices at the "
     "barycentres. With c_n = 0 the surface is nearest to the cube, with 1 it has contracted most. All "
     "pass through the middles of the cube's faces (eq 15), which at c_n = 1 have become tips.",
     vertexPull},
};

}  // namespace

std::span<const Plate> zhangWangPlates() {
  return kPlates;
}

}  // namespace honeycomb::Gallery
