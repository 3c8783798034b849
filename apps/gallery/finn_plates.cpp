#include "apps/gallery/plates.h"
#include "apps/gallery/sheet.h"
#include "far/schemes/akleman.h"
#include "far/schemes/centroid.h"
#include "far/schemes/doo_sabin.h"
#include "far/schemes/half_box.h"
#include "far/schemes/midpoint.h"
#include "far/schemes/trisect.h"
#include "far/schemes/zhang_wang.h"

namespace honeycomb::Gallery {
namespace {

using Device = Osd::VulkanDevice;

Result<Viewer::Picture> finnCube(const Device& device) {
  const Shape shape = cube();
  Sheet sheet(device, {206, 196}, 5);
  sheet.frame(shape.points, {0.5F, 0.45F, 1.0F});
  const Result<Far::Scheme> schemes[] = {Far::midpoint(), Far::trisect(), Far::centroid()};
  for (const auto& scheme : schemes) {
    for (std::int32_t levels = 0; levels <= 4; ++levels) {
      sheet.add(refined(shape, steps(scheme, levels), Shading::faceted));
    }
  }
  return sheet.finish();
}

/// A row of the sheet of all schemes.
struct Row {
  Shading shading;
  Result<std::vector<Far::Scheme>> (*chain)(const Far::Topology& control, std::int32_t levels);
};

constexpr Row kRows[] = {
    {Shading::smooth, [](const Far::Topology&, std::int32_t levels) { return steps(Far::akleman(), levels); }},
    {Shading::smooth,
     [](const Far::Topology& control, std::int32_t levels) { return Far::zhangWang(control, levels); }},
    {Shading::smooth, [](const Far::Topology& control, std::int32_t levels) { return Far::halfBox(control, levels); }},
    {Shading::smooth, [](const Far::Topology&, std::int32_t levels) { return steps(Far::dooSabin(), levels); }},
    {Shading::faceted, [](const Far::Topology&, std::int32_t levels) { return steps(Far::midpoint(), levels); }},
    {Shading::faceted, [](const Far::Topology&, std::int32_t levels) { return steps(Far::trisect(), levels); }},
    {Shading::faceted, [](const Far::Topology&, std::int32_t levels) { return steps(Far::centroid(), levels); }},
};

Result<Viewer::Picture> allSchemes(const Device& device) {
  const Shape shape = blockT();
  const auto topology = Far::Topology::create(shape.polygons);
  if (!topology) return tl::unexpected(topology.error());
  Sheet sheet(device, {176, 168}, 5);
  sheet.frame(shape.points, {0.6F, 0.45F, 1.0F});
  for (const Row& row : kRows) {
    sheet.add(refined(shape, std::vector<Far::Scheme>()));
    for (std::int32_t levels = 1; levels <= 4; ++levels) {
      sheet.add(refined(shape, row.chain(*topology, levels), row.shading));
    }
  }
  return sheet.finish();
}

constexpr Plate kPlates[] = {
    {"finn_cube", "Finn's methods on a cube",
     "After D. Finn, course notes *Simple Subdivision Methods*, Figures 1 to 3. Rows: the midpoint "
     "algorithm (Figure 2), trisection, and the centroid method (Figure 3); a cube and four steps of each, "
     "every face shaded by its own normal. All of them cut corners (Figure 1), so that every vertex "
     "becomes a face; the centroid method also makes one of every edge. Trisection doubles the sides of "
     "faces and leaves parts of the cube's faces flat.",
     finnCube},
    {"schemes", "All schemes on one mesh",
     "Not from a paper. A block T and four levels of it by each scheme. Rows: Akleman and Srinivasan; "
     "Zhang and Wang; half-box splines (Barendrecht, Sabin and Kosinka), whose mesh was made three-valent "
     "by one step of the first; Doo and Sabin; Finn's midpoint, trisection and centroid methods, faces of "
     "the last three shaded by their own normals.",
     allSchemes},
};

}  // namespace

std::span<const Plate> finnPlates() {
  return kPlates;
}

}  // namespace honeycomb::Gallery
