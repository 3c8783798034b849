#include "apps/gallery/patches.h"

#include <algorithm>
#include <cmath>

#include "apps/gallery/strips.h"
#include "far/base/index.h"

namespace honeycomb::Gallery {
namespace {

constexpr std::int32_t kSamplesPerLine = 12;

Far::Barycentric between(const Far::Barycentric& a, const Far::Barycentric& b, double t) {
  Far::Barycentric mixed{};
  for (std::size_t i = 0; i < 3; ++i) mixed[i] = (1 - t) * a[i] + t * b[i];
  return mixed;
}

/// Corner (i, j) of a triangle cut into n x n, counted from its first corner towards the other two.
Far::Barycentric placeIn(const PatchTriangle& part, double i, double j, double n) {
  Far::Barycentric place{};
  for (std::size_t k = 0; k < 3; ++k) place[k] = ((n - i - j) * part[0][k] + i * part[1][k] + j * part[2][k]) / n;
  return place;
}

struct Sample {
  glm::vec3 position;
  glm::vec3 normal;
};

Result<Sample> sampleAt(const Far::PatchTable& table, std::span<const float> points, std::int32_t patch,
                        const Far::Barycentric& place) {
  const auto point = table.evaluate<float>(patch, place, points);
  if (!point) return tl::unexpected(point.error());
  const auto& p = point->position;
  const auto& n = point->normal;
  return Sample{glm::vec3(p[0], p[1], p[2]), glm::vec3(n[0], n[1], n[2])};
}

/// Calls add(i, j, upright) for each of the n x n triangles: (i, j), (i+1, j), (i, j+1), or with upright false (i+1,
/// j), (i+1, j+1), (i, j+1).
template <class Add>
void forEachPiece(std::int32_t n, const Add& add) {
  for (std::int32_t i = 0; i < n; ++i) {
    for (std::int32_t j = 0; i + j < n; ++j) {
      add(i, j, true);
      if (i + j + 1 < n) add(i, j, false);
    }
  }
}

}  // namespace

std::array<PatchTriangle, 3> ringTriangles(std::size_t corner, std::int32_t ring) {
  const double size = std::ldexp(1.0, -ring);
  PatchTriangle outer{};
  for (std::size_t k = 0; k < 3; ++k) {
    Far::Barycentric end{};
    end[(corner + k) % 3] = 1;
    outer[k] = between(kWholePatch[corner], end, size);
  }
  const Far::Barycentric ab = between(outer[0], outer[1], 0.5);
  const Far::Barycentric bc = between(outer[1], outer[2], 0.5);
  const Far::Barycentric ca = between(outer[2], outer[0], 0.5);
  return {{{ab, outer[1], bc}, {ca, bc, outer[2]}, {bc, ca, ab}}};
}

std::int32_t cornerIn(const Far::PatchTable& table, std::int32_t patch, std::int32_t face) {
  const auto faces = table.patch(patch).faces();
  const auto found = std::find(faces.begin(), faces.end(), face);
  return found == faces.end() ? -1 : static_cast<std::int32_t>(found - faces.begin());
}

Result<void> addPatch(Model& model, const Far::PatchTable& table, std::span<const float> points, std::int32_t patch,
                      const PatchTriangle& part, const PatchStyle& style) {
  const std::int32_t n = style.pieces;
  const auto middle = sampleAt(table, points, patch, placeIn(part, 1, 1, 3));
  if (!middle) return tl::unexpected(middle.error());
  std::vector<std::int32_t> numbers;
  for (std::int32_t i = 0; i <= n; ++i) {
    for (std::int32_t j = 0; i + j <= n; ++j) {
      const auto sample = sampleAt(table, points, patch, placeIn(part, i, j, n));
      if (!sample) return tl::unexpected(sample.error());
      numbers.push_back(model.addPoint(sample->position + style.offset, style.flat ? middle->normal : sample->normal));
    }
  }
  // Row i has n + 1 - i points.
  const auto number = [&](std::int32_t i, std::int32_t j) { return numbers[at(i * (2 * n + 3 - i) / 2 + j)]; };
  const auto normalOf = [&](std::int32_t v) {
    return glm::vec3(model.normals[at(3 * v)], model.normals[at(3 * v) + 1], model.normals[at(3 * v) + 2]);
  };
  forEachPiece(n, [&](std::int32_t i, std::int32_t j, bool upright) {
    const std::array<std::int32_t, 3> loop{upright ? number(i, j) : number(i + 1, j),
                                           upright ? number(i + 1, j) : number(i + 1, j + 1), number(i, j + 1)};
    const glm::vec3 sum = normalOf(loop[0]) + normalOf(loop[1]) + normalOf(loop[2]);
    model.addFace(loop, style.colour(glm::normalize(sum)));
  });
  return {};
}

Result<void> addIsoLines(Model& model, const Far::PatchTable& table, std::span<const float> points, std::int32_t patch,
                         std::int32_t pieces, float width, Viewer::Rgb colour) {
  for (std::size_t coordinate = 0; coordinate < 3; ++coordinate) {
    for (std::int32_t i = 0; i < pieces; ++i) {
      std::vector<glm::vec3> line;
      for (std::int32_t s = 0; s <= kSamplesPerLine; ++s) {
        Far::Barycentric place{};
        place[coordinate] = static_cast<double>(i) / pieces;
        place[(coordinate + 1) % 3] = (1 - place[coordinate]) * s / kSamplesPerLine;
        place[(coordinate + 2) % 3] = 1 - place[coordinate] - place[(coordinate + 1) % 3];
        const auto sample = sampleAt(table, points, patch, place);
        if (!sample) return tl::unexpected(sample.error());
        line.push_back(sample->position);
      }
      addStrip(model, line, i == 0 ? width : 0.5F * width, colour);
    }
  }
  return {};
}

}  // namespace honeycomb::Gallery
