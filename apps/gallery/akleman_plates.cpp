#include "apps/gallery/plates.h"
#include "apps/gallery/sheet.h"
#include "far/conversions/bricks.h"
#include "far/schemes/akleman.h"

namespace honeycomb::Gallery {
namespace {

using Device = Osd::VulkanDevice;

constexpr Viewer::RendererOptions kTile{270, 252};
const glm::vec3 kSide(0.45F, 0.42F, 1.0F);

Result<Model> afterSteps(const Shape& shape, std::int32_t levels, const Far::AklemanOptions& options = {}) {
  return refined(shape, steps(Far::akleman(options), levels));
}

Result<Viewer::Picture> iterations(const Device& device) {
  const Shape shape = dodecahedron();
  Sheet sheet(device, kTile, 3);
  sheet.frame(shape.points, kSide);
  for (std::int32_t levels = 0; levels <= 5; ++levels) sheet.add(afterSteps(shape, levels));
  return sheet.finish();
}

Result<Viewer::Picture> edgeParameter(const Device& device) {
  const Shape shape = dodecahedron();
  Sheet sheet(device, kTile, 4);
  sheet.frame(shape.points, kSide);
  for (const double t : {0.125, 0.25, 0.5, 0.75}) {
    Far::AklemanOptions options;
    options.edgeParameter = t;
    sheet.add(afterSteps(shape, 4, options));
  }
  return sheet.finish();
}

Result<Viewer::Picture> tension(const Device& device) {
  const Shape shape = dodecahedron();
  Sheet sheet(device, kTile, 4);
  sheet.frame(shape.points, kSide);
  for (const double a : {0.25, 0.5, 0.75, 0.95}) {
    Far::AklemanOptions options;
    options.tension = {Far::Tension::Rule::constant, a};
    sheet.add(afterSteps(shape, 4, options));
  }
  return sheet.finish();
}

Result<Viewer::Picture> controlShapes(const Device& device) {
  Sheet sheet(device, kTile, 4);
  for (const Shape& shape : {cube(), star(5), blockT(), torus(6, 4), chair(), twoHoles()}) {
    sheet.frame(shape.points, {0.6F, 0.5F, 1.0F});
    sheet.add(afterSteps(shape, 0));
    sheet.add(afterSteps(shape, 4));
  }
  return sheet.finish();
}

/// The shape with its sides laid in `rows` courses of bricks.
Result<Shape> laidInBricks(const Shape& shape, std::int32_t rows) {
  const auto topology = Far::Topology::create(shape.polygons);
  if (!topology) return tl::unexpected(topology.error());
  const auto conversion = Far::bricks(*topology, rows);
  if (!conversion) return tl::unexpected(conversion.error());
  const std::vector<double> source(shape.points.begin(), shape.points.end());
  const auto points = Far::apply(*conversion, source, 3);
  if (!points) return tl::unexpected(points.error());
  Shape laid{conversion->polygons, {}};
  for (const double number : *points) laid.points.push_back(static_cast<float>(number));
  return laid;
}

Result<Viewer::Picture> bricklayers(const Device& device) {
  Sheet sheet(device, kTile, 4);
  for (const std::int32_t sides : {6, 24}) {
    const Shape plain = prism(sides, 2);
    const auto laid = laidInBricks(plain, sides == 6 ? 3 : 5);
    if (!laid) return tl::unexpected(laid.error());
    sheet.frame(plain.points, {0.5F, 0.35F, 1.0F});
    for (const Shape& shape : {plain, *laid}) {
      sheet.add(afterSteps(shape, 0));
      sheet.add(afterSteps(shape, 5));
    }
  }
  return sheet.finish();
}

constexpr Plate kPlates[] = {
    {"akleman_iterations", "Five iterations over a dodecahedron",
     "After E. Akleman, V. Srinivasan, *Honeycomb Subdivision*, Figure 1. M0 to M5: a dodecahedron, the "
     "soccer ball, and four more levels, whose patterns the paper finds in viruses. The twelve pentagons "
     "stay twelve; all other faces are hexagons.",
     iterations},
    {"akleman_edge_parameter", "The effect of t",
     "After E. Akleman, V. Srinivasan, *Honeycomb Subdivision*, Figure 3 of the version with eight "
     "figures. Four iterations over a dodecahedron with t = 0.125, 0.25, 0.5 (M4 of Figure 1) and 0.75. "
     "Only 0.5 is a value named in the paper's text. Away from 0.5 the cells turn into pinwheels; t and 1 "
     "- t give mirror images, as 0.25 and 0.75 here.",
     edgeParameter},
    {"akleman_tension", "The effect of a",
     "After E. Akleman, V. Srinivasan, *Honeycomb Subdivision*, Figure 4 of the version with eight "
     "figures. Four iterations over a dodecahedron with a = 0.25, 0.5, 0.75 and 0.95 for faces of every "
     "size; the values are ours, the paper's text names none. a controls how fast faces shrink to their "
     "centres: where it is small the old faces end in tips, where it is near 1 the control mesh shows "
     "through after four iterations.",
     tension},
    {"akleman_shapes", "Control shapes and their meshes after four iterations",
     "After E. Akleman, V. Srinivasan, *Honeycomb Subdivision*, Figure 3 (Figure 7 of the version with "
     "eight figures). Pairs, left the control mesh, right the mesh after four iterations: cube and star; "
     "block T and torus; chair and a plate with two holes. The shapes are ours. Dark blue cells "
     "come from control vertices of valence 4 and more, on the star from its ten-sided cap.",
     controlShapes},
    {"akleman_bricklayers", "The bricklayers' problem and its cure",
     "After E. Akleman, V. Srinivasan, *Honeycomb Subdivision*, Figure 4 (Figure 8 of the version with "
     "eight figures), A to D in each row: a prism; its mesh after five iterations, with bumps round its "
     "sides; the prism with its sides laid in courses of bricks (`honeycomb convert --to bricks`), "
     "hexagons inside and pentagons at the rims; the mesh of that after five iterations. Above the paper's "
     "hexagonal prism, in three courses, below one of 24 sides, in five. In the middle tenth of the height "
     "the radius varies by 2.4 % in B and 0.9 % in D above, by 3.2 % and 0.15 % below: on six sides the "
     "bricks have to bend round the prism's edges, so that they cure less (and bent "
     "hexagons, drawn with the mean of their corners in the middle, look dented in C). The paper's text does not "
     "describe its C; this is our reading of it.",
     bricklayers},
};

}  // namespace

std::span<const Plate> aklemanPlates() {
  return kPlates;
}

}  // namespace honeycomb::Gallery
