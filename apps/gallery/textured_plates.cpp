#include <algorithm>
#include <array>
#include <cmath>

#include "apps/gallery/plates.h"
#include "apps/gallery/sheet.h"
#include "far/base/index.h"
#include "far/schemes/akleman.h"
#include "far/tables/face_varying.h"
#include "io/obj.h"
#include "osd/cpu_evaluator.h"

namespace honeycomb::Gallery {
namespace {

using Device = Osd::VulkanDevice;

constexpr std::int32_t kCharts = 6;

/// Texture coordinates at the corners of a mesh: u v each, and which of them each corner has.
struct Texture {
  std::vector<double> values;
  std::vector<std::int32_t> corners;
};

glm::dvec3 pointOf(const Io::Mesh& mesh, std::int32_t v) {
  const auto p = mesh.position(v);
  return {p[0], p[1], p[2]};
}

std::span<const std::int32_t> loopOf(const Far::Polygons& polygons, std::int64_t f) {
  const std::int64_t first = polygons.faceOffsets[at(f)];
  return std::span(polygons.indices).subspan(at(first), at(polygons.faceOffsets[at(f) + 1] - first));
}

/// The side of a box that a face looks towards: 2 axis + 1, or + 0 where it looks down the axis.
std::int32_t chartOf(const Io::Mesh& mesh, std::span<const std::int32_t> loop) {
  glm::dvec3 normal(0);
  for (std::size_t k = 0; k < loop.size(); ++k)
    normal += glm::cross(pointOf(mesh, loop[k]), pointOf(mesh, loop[(k + 1) % loop.size()]));
  int axis = 0;
  for (const int other : {1, 2})
    if (std::abs(normal[other]) > std::abs(normal[axis])) axis = other;
  return 2 * axis + (normal[axis] > 0 ? 1 : 0);
}

/// Six charts, the mesh seen from the sides of a box, each on its tile of the texture: three tiles beside each other,
/// two rows. Corners of a vertex in one chart share a value: seams run where faces of two charts meet.
Texture boxCharts(const Io::Mesh& mesh) {
  const std::int32_t vertexCount = mesh.polygons.vertexCount;
  glm::dvec3 lower = pointOf(mesh, 0), upper = lower;
  for (std::int32_t v = 1; v < vertexCount; ++v) {
    lower = glm::min(lower, pointOf(mesh, v));
    upper = glm::max(upper, pointOf(mesh, v));
  }
  const glm::dvec3 size = upper - lower;
  const double scale = 0.8 / std::max({size.x, size.y, size.z});
  Texture texture;
  texture.values.reserve(2 * at(vertexCount) * kCharts);
  for (std::int32_t v = 0; v < vertexCount; ++v) {
    const glm::dvec3 p = (pointOf(mesh, v) - 0.5 * (lower + upper)) * scale;
    for (std::int32_t chart = 0; chart < kCharts; ++chart) {
      const int axis = chart / 2;
      texture.values.push_back(axis + 0.5 + p[(axis + 1) % 3]);
      texture.values.push_back(chart % 2 + 0.5 + p[(axis + 2) % 3]);
    }
  }
  for (std::int64_t f = 0; f < mesh.polygons.faceCount(); ++f) {
    const auto loop = loopOf(mesh.polygons, f);
    for (const std::int32_t v : loop) texture.corners.push_back(kCharts * v + chartOf(mesh, loop));
  }
  return texture;
}

/// The same with a single value for each vertex, that of its first corner: what is left of charts where texture
/// coordinates are a primvar of the vertices.
Texture ofVertices(const Io::Mesh& mesh, Texture texture) {
  std::vector<std::int32_t> first(at(mesh.polygons.vertexCount), -1);
  for (std::size_t c = 0; c < texture.corners.size(); ++c) {
    std::int32_t& value = first[at(mesh.polygons.indices[c])];
    if (value < 0) value = texture.corners[c];
    texture.corners[c] = value;
  }
  return texture;
}

/// The texture of the last level.
Result<Texture> refined(const Far::Refinement& refinement, const Texture& texture) {
  constexpr Osd::BufferDescriptor kPairs{0, 2, 2};
  const auto varying = Far::FaceVarying::build(refinement, {2, texture.values, texture.corners});
  if (!varying) return tl::unexpected(varying.error());
  Osd::TbbEvaluator evaluator;
  std::vector<double> values = texture.values;
  for (std::int32_t k = 1; k <= varying->levelCount(); ++k) {
    std::vector<double> finer(2 * at(varying->level(k).valueCount));
    const auto done = evaluator.evaluate<double>(varying->level(k).table, {values, kPairs}, {finer, kPairs});
    if (!done) return tl::unexpected(done.error());
    values = std::move(finer);
  }
  return Texture{std::move(values), varying->last().corners};
}

/// The image: each tile a checkerboard in a colour of its own. Linear between 0 and 255.
glm::dvec3 imageAt(double u, double v) {
  static constexpr std::array<std::uint32_t, kCharts> kColours{0x3c6e8f, 0xc23b55, 0xe0a83a,
                                                               0x4f9a6a, 0x7a5aa0, 0xe2723f};
  constexpr double kChecks = 26;  // along a tile
  const int column = std::clamp(static_cast<int>(std::floor(u)), 0, 2),
            row = std::clamp(static_cast<int>(std::floor(v)), 0, 1);
  const auto parity =
      static_cast<std::int64_t>(std::floor(u * kChecks)) + static_cast<std::int64_t>(std::floor(v * kChecks));
  if (parity % 2 == 0) return {0xf2, 0xef, 0xe6};
  const std::uint32_t colour = kColours[at(2 * column + row)];
  return {(colour >> 16) & 255U, (colour >> 8) & 255U, colour & 255U};
}

/// The image's mean over a face: over its corners, half-way from them to its middle, and there.
Viewer::Rgb faceColour(const Texture& texture, std::int32_t begin, std::int32_t end) {
  const auto corner = [&](std::int32_t c) {
    const std::size_t value = 2 * at(texture.corners[at(c)]);
    return glm::dvec2(texture.values[value], texture.values[value + 1]);
  };
  glm::dvec2 middle(0);
  for (std::int32_t c = begin; c < end; ++c) middle += corner(c) / static_cast<double>(end - begin);
  glm::dvec3 sum = imageAt(middle.x, middle.y);
  for (std::int32_t c = begin; c < end; ++c) {
    for (const double part : {0.45, 0.9}) {
      const glm::dvec2 place = glm::mix(middle, corner(c), part);
      sum += imageAt(place.x, place.y);
    }
  }
  const glm::dvec3 mean = sum / static_cast<double>(2 * (end - begin) + 1);
  std::uint32_t colour = 0;
  for (int channel = 0; channel < 3; ++channel)
    colour = colour << 8 | static_cast<std::uint32_t>(std::lround(mean[channel]));
  return {colour};
}

Result<Model> textured(const Surface& surface, const Texture& control) {
  auto model = modelOf(surface, Shading::smooth);
  if (!model) return model;
  const auto texture = refined(surface.refinement, control);
  if (!texture) return tl::unexpected(texture.error());
  for (std::int32_t f = 0; f < surface.refinement.last().topology.faceCount(); ++f)
    model->setColour(f, faceColour(*texture, model->faceOffsets[at(f)], model->faceOffsets[at(f) + 1]));
  return model;
}

/// The points of the first third of the animal, which looks along x.
std::vector<float> headOf(const std::vector<float>& points) {
  const Viewer::Bounds bounds = Viewer::boundsOf(points);
  const float neck = bounds.upper.x - 0.27F * (bounds.upper.x - bounds.lower.x);
  std::vector<float> head;
  for (std::size_t i = 0; i < points.size(); i += 3)
    if (points[i] > neck)
      head.insert(head.end(), points.begin() + static_cast<std::ptrdiff_t>(i),
                  points.begin() + static_cast<std::ptrdiff_t>(i) + 3);
  return head;
}

Result<Viewer::Picture> texturedCharacter(const Device& device) {
  constexpr std::int32_t kLevels = 5;
  const auto mesh = Io::readObj(HONEYCOMB_ASSETS "/creature.obj");
  if (!mesh) return tl::unexpected(mesh.error());
  const auto chain = steps(Far::akleman(), kLevels);
  if (!chain) return tl::unexpected(chain.error());
  const auto surface = refine({mesh->polygons, {mesh->positions.begin(), mesh->positions.end()}}, *chain, true);
  if (!surface) return tl::unexpected(surface.error());
  const Texture charts = boxCharts(*mesh);
  const std::array models{textured(*surface, ofVertices(*mesh, charts)), textured(*surface, charts)};
  Sheet sheet(device, {480, 330}, 2);
  sheet.style().edgeStrength = 0;
  sheet.frame(surface->points, {0.75F, 0.62F, 0.80F});
  for (const auto& model : models) sheet.add(model);
  sheet.frame(headOf(surface->points), {0.75F, 0.45F, 0.80F}, 0);
  for (const auto& model : models) sheet.add(model);
  return sheet.finish();
}

constexpr Plate kPlates[] = {
    {"textured", "A textured character",
     "Not from a paper. The animal of the demo and its head after five levels of Akleman and Srinivasan's scheme, "
     "textured from the six sides of a box: six charts, with seams where they meet, and a tile of the image for each, "
     "whose checks have its own colour. Left: texture coordinates as a primvar of the vertices. A vertex on a seam "
     "keeps the value of one chart, and every face beside it runs across the image. Right: the same charts as "
     "face-varying values (`Far::FaceVarying`). A face made from a face refines from its own corners, as if it stood "
     "alone. A cell made from a vertex or an edge that straddles a seam takes the chart of its first face, and its "
     "other corners are carried over into that chart. So the checks reach the seam undisturbed, the seam runs along "
     "the borders of cells, and no cell reaches across the image.",
     texturedCharacter},
};

}  // namespace

std::span<const Plate> texturedPlates() {
  return kPlates;
}

}  // namespace honeycomb::Gallery
