#include <algorithm>
#include <cmath>
#include <numbers>

#include "apps/gallery/configuration.h"
#include "apps/gallery/patches.h"
#include "apps/gallery/plates.h"
#include "apps/gallery/sheet.h"
#include "far/base/index.h"
#include "far/schemes/half_box.h"

namespace honeycomb::Gallery {
namespace {

using Device = Osd::VulkanDevice;

constexpr Viewer::Rgb kRingColours[] = {{0xb9d3c6}, {0x5f97a8}};
constexpr Viewer::Rgb kPale{0xcfd8cf};

/// Spline rings of a surface round its middle face, one above the other.
struct Rings {
  std::int32_t count = 5;
  float rise = 0;  ///< of the innermost over the outermost, about
  bool flat = false;
  bool isophotes = false;
};

/// Stripes of equal angle to a direction.
Viewer::Rgb isophote(const glm::vec3& normal) {
  constexpr float kStripes = 24;  // of the half circle
  const float facing = glm::dot(normal, glm::normalize(glm::vec3(-0.5F, 1.0F, 0.3F)));
  const float stripe = kStripes * std::acos(std::clamp(facing, -1.0F, 1.0F)) / std::numbers::pi_v<float>;
  return std::fmod(stripe, 2.0F) < 1 ? Viewer::Rgb{0x303a40} : Viewer::Rgb{0xf2efe6};
}

PatchStyle ringStyle(const Rings& rings, std::int32_t ring) {
  PatchStyle style;
  style.flat = rings.flat;
  style.pieces = rings.isophotes ? std::max(16, 128 >> ring) : std::max(4, 16 >> ring);
  style.offset = {0, rings.rise * (1 - std::pow(0.7F, static_cast<float>(ring))), 0};
  const Viewer::Rgb colour = kRingColours[ring % 2];
  style.colour = [colour](const glm::vec3&) { return colour; };
  if (rings.isophotes) style.colour = isophote;
  return style;
}

/// Rings of the patches at the middle face's corners; `first` is the number the outermost gets.
Result<void> addRings(Model& model, const Far::PatchTable& table, std::span<const float> points, std::int32_t middle,
                      const Rings& rings, std::int32_t first) {
  for (std::int32_t p = 0; p < table.patchCount(); ++p) {
    const std::int32_t corner = cornerIn(table, p, middle);
    if (corner < 0) continue;
    for (std::int32_t ring = first; ring < rings.count; ++ring) {
      for (const PatchTriangle& part : ringTriangles(at(corner), ring - first)) {
        if (auto added = addPatch(model, table, points, p, part, ringStyle(rings, ring)); !added) return added;
      }
    }
  }
  return {};
}

/// A hill round a pentagon, with the ring of regular patches round it.
Result<Model> pentagonRings(const Configuration& pentagon, const Shape& hill, const Rings& rings) {
  Model model;
  const Far::PatchTable& table = pentagon.finerTable;
  for (const std::int32_t p : table.regularPatches()) {
    const auto added = addPatch(model, table, hill.points, p, kWholePatch, ringStyle(rings, 0));
    if (!added) return tl::unexpected(added.error());
  }
  const auto added = addRings(model, table, hill.points, pentagon.finerMiddle, rings, 1);
  if (!added) return tl::unexpected(added.error());
  return model;
}

Result<Viewer::Picture> rings(const Device& device) {
  const auto pentagon = configuration(5);
  if (!pentagon) return tl::unexpected(pentagon.error());
  const Shape hill =
      lifted(pentagon->finer, [](std::size_t, float x, float z) { return 1.0F - 0.6F * (x * x + z * z); });
  Sheet sheet(device, {300, 280}, 3);
  const auto flat = pentagonRings(*pentagon, hill, {5, 0.6F, true, false});
  const auto smooth = pentagonRings(*pentagon, hill, {5, 0.6F, false, false});
  const auto together = pentagonRings(*pentagon, hill, {7, 0, false, false});
  sheet.style().edgeStrength = 0;
  for (const auto& model : {flat, smooth, together}) {
    if (model) sheet.frame(model->points, {0.3F, 1.1F, 1.0F});
    sheet.add(model);
  }
  return sheet.finish();
}

Result<Viewer::Picture> characteristicRings(const Device& device) {
  Sheet sheet(device, {270, 252}, 3);
  sheet.style().edgeStrength = 0;
  for (const std::int32_t sides : {3, 4}) {
    const auto made = configuration(sides);
    if (!made) return tl::unexpected(made.error());
    const Shape raised = lifted(
        made->mesh, [&](std::size_t v, float, float) { return v < static_cast<std::size_t>(sides) ? 1.0F : 0.0F; });
    for (const Rings& look : {Rings{4, 0.7F, true, false}, Rings{4, 0.7F, false, false}, Rings{4, 0.7F, false, true}}) {
      Model model;
      const auto added = addRings(model, made->table, raised.points, made->middle, look, 0);
      sheet.frame(model.points, {0.2F, 0.9F, 1.0F});
      sheet.add(added ? Result<Model>(model) : tl::unexpected(added.error()));
    }
  }
  return sheet.finish();
}

/// Half-way to white.
Viewer::Rgb pale(Viewer::Rgb colour) {
  return {0x7f7f7fU + ((colour.value >> 1) & 0x7f7f7fU)};
}

/// The limit surface of a three-valent mesh. Patches beside a face that isn't a hexagon have its colour.
Result<Model> limitSurface(const Far::PatchTable& table, std::span<const float> points, bool flat) {
  const Viewer::Palette palette;
  Model model;
  for (std::int32_t p = 0; p < table.patchCount(); ++p) {
    Viewer::Rgb colour = kPale;
    for (const std::int32_t n : table.patch(p).sides()) {
      if (n != 6) colour = pale(palette.of(n));
    }
    PatchStyle style;
    style.flat = flat;
    style.pieces = 6;
    style.colour = [&](const glm::vec3&) { return flat ? colour : kPale; };
    if (const auto added = addPatch(model, table, points, p, kWholePatch, style); !added) {
      return tl::unexpected(added.error());
    }
  }
  return model;
}

Result<Viewer::Picture> limits(const Device& device) {
  const Shape shape = blockT();
  const auto topology = Far::Topology::create(shape.polygons);
  if (!topology) return tl::unexpected(topology.error());
  const auto conversion = Far::halfBox(*topology, 0);
  if (!conversion) return tl::unexpected(conversion.error());
  const auto control = refine(shape, *conversion);
  if (!control) return tl::unexpected(control.error());
  const auto table = Far::PatchTable::build(control->refinement.last().topology);
  if (!table) return tl::unexpected(table.error());
  Sheet sheet(device, {270, 252}, 4);
  sheet.frame(control->points, {0.6F, 0.45F, 1.0F});
  sheet.add(refined(shape, conversion, Shading::faceted));
  sheet.add(refined(shape, Far::halfBox(*topology, 1), Shading::faceted));
  sheet.style().edgeStrength = 0;
  for (const bool flat : {true, false}) sheet.add(limitSurface(*table, control->points, flat));
  return sheet.finish();
}

constexpr Plate kPlates[] = {
    {"half_box_rings", "Spline rings round a pentagon",
     "After P. Barendrecht, M. Sabin, J. Kosinka, *A bivariate C1 subdivision scheme based on cubic half- "
     "box splines*, Figure 10. The limit surface round an isolated pentagon, a hill, whose spline rings "
     "have two colours by turns: rings raised one above the other, each patch shaded by one normal; the "
     "same, smooth; all in place.",
     rings},
    {"half_box_limits", "A three-valent mesh and its limit surface",
     "After P. Barendrecht, M. Sabin, J. Kosinka, *A bivariate C1 subdivision scheme based on cubic half- "
     "box splines*, Figure 11, with a mesh of ours: a block T, made three-valent by one step of honeycomb "
     "subdivision; one step of half-box subdivision; the limit surface, each patch (one for each vertex of "
     "the first mesh) shaded by one normal, and tinted where it touches an octagon or quad; the same, "
     "smooth.",
     limits},
    {"half_box_characteristic_rings", "Characteristic rings in space",
     "After P. Barendrecht, M. Sabin, J. Kosinka, *A bivariate C1 subdivision scheme based on cubic half- "
     "box splines*, Figure A.15. n = 3 above, n = 4 below, with the original second stencil: the vertices "
     "of the n-gon of the natural configuration raised to height 1, all others at 0, and four spline rings "
     "one above the other: each patch shaded by one normal, smooth, and with isophotes, which have no "
     "gaps, as the surface has a continuous tangent plane.",
     characteristicRings},
};

}  // namespace

std::span<const Plate> halfBoxPlates() {
  return kPlates;
}

}  // namespace honeycomb::Gallery
