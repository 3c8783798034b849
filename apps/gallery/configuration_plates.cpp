#include <algorithm>
#include <cmath>

#include "apps/gallery/configuration.h"
#include "apps/gallery/patches.h"
#include "apps/gallery/plates.h"
#include "apps/gallery/sheet.h"
#include "apps/gallery/strips.h"

namespace honeycomb::Gallery {
namespace {

using Device = Osd::VulkanDevice;

constexpr std::int32_t kRings = 5;
constexpr Viewer::Rgb kRingColours[] = {{0xfbf7ea}, {0xe6d9b0}};
constexpr Viewer::Rgb kGrey{0x838b94};
constexpr Viewer::Rgb kBlack{0x141414};
constexpr float kLayer = 0.002F;  // between what lies on top of each other, of the mesh's radius

/// One ring of the characteristic map: the first one, halved `ring` times.
Result<void> addRing(Model& model, const Configuration& made, std::int32_t ring, float radius) {
  const Viewer::Rgb colour = kRingColours[ring % 2];
  PatchStyle fill;
  fill.pieces = 4;
  const float width = 0.006F * radius * std::pow(0.75F, static_cast<float>(ring));
  fill.colour = [colour](const glm::vec3&) { return colour; };
  std::vector<float> ground = made.finer.points;
  for (float& number : ground) number = std::ldexp(number, -ring);
  std::vector<float> above = ground;
  for (std::size_t i = 1; i < above.size(); i += 3) above[i] += 2 * kLayer * radius;
  for (std::int32_t p = 0; p < made.finerTable.patchCount(); ++p) {
    if (cornerIn(made.finerTable, p, made.finerMiddle) >= 0) continue;
    auto added = addPatch(model, made.finerTable, ground, p, kWholePatch, fill);
    if (added) added = addIsoLines(model, made.finerTable, above, p, std::max(1, 4 >> ring), width, kBlack);
    if (!added) return added;
  }
  return {};
}

/// The characteristic map, ring after ring, and the mesh it is the limit surface of.
Result<Model> planOf(const Configuration& made) {
  Model model;
  const float radius = Viewer::boundsOf(made.mesh.points).radius();
  for (std::int32_t ring = 0; ring < kRings; ++ring) {
    if (const auto added = addRing(model, made, ring, radius); !added) return tl::unexpected(added.error());
  }
  addEdges(model, lifted(made.mesh, [&](std::size_t, float, float) { return kLayer * radius; }), 0.014F * radius,
           kGrey);
  return model;
}

Result<Viewer::Picture> draw(const Device& device, std::span<const std::pair<std::int32_t, double>> faces,
                             std::int32_t columns) {
  Sheet sheet(device, {310, 310}, columns);
  sheet.style().edgeStrength = 0;
  for (const auto& [sides, weight] : faces) {
    const auto made = configuration(sides, weight);
    if (!made) return tl::unexpected(made.error());
    sheet.frame(made->mesh.points, {0, 1, 0});
    sheet.add(planOf(*made));
  }
  return sheet.finish();
}

Result<Viewer::Picture> original(const Device& device) {
  constexpr std::pair<std::int32_t, double> kFaces[] = {{3, 0.25}, {4, 0.25}, {5, 0.25},
                                                        {6, 0.25}, {7, 0.25}, {8, 0.25}};
  return draw(device, kFaces, 3);
}

Result<Viewer::Picture> tuned(const Device& device) {
  constexpr std::pair<std::int32_t, double> kFaces[] = {{3, 0.45}, {4, 0.35}};
  return draw(device, kFaces, 2);
}

constexpr Plate kPlates[] = {
    {"half_box_configurations", "Natural configurations and characteristic maps",
     "After P. Barendrecht, M. Sabin, J. Kosinka, *A bivariate C1 subdivision scheme based on cubic half- "
     "box splines*, Figure 8. n = 3, 4, 5; 6, 7, 8, with the original second stencil. Grey: the natural "
     "configuration, the n-gon and the hexagons round it as a step of subdivision leaves them but for "
     "their size. Black: the characteristic map, which is its limit surface, with iso-lines; each spline "
     "ring is half as large as the one round it. As the paper says, for n = 3 polygons cross themselves "
     "and for n = 3 and 4 vertices coincide (for 3 the outer neighbours of the three corners, all in the "
     "middle; for 4 each corner and its neighbour), and the maps are regular and one-to-one all the same.",
     original},
    {"half_box_tuned_configurations", "Improved natural configurations",
     "After P. Barendrecht, M. Sabin, J. Kosinka, *A bivariate C1 subdivision scheme based on cubic half- "
     "box splines*, Figure A.16. n = 3 with b = 0.45 and n = 4 with b = 0.35 in the tuned second stencil: "
     "no vertices coincide, no polygon crosses itself.",
     tuned},
};

}  // namespace

std::span<const Plate> configurationPlates() {
  return kPlates;
}

}  // namespace honeycomb::Gallery
