#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "apps/gallery/shapes.h"
#include "apps/viewer/style.h"
#include "far/base/result.h"
#include "far/schemes/scheme.h"
#include "far/tables/refinement.h"

namespace honeycomb::Gallery {

/// What a picture shows: faces with colours, points with normals.
struct Model {
  std::vector<std::int32_t> faceOffsets{0};
  std::vector<std::int32_t> corners;
  std::vector<std::uint32_t> colours;  ///< one a face: 0xAABBGGRR, as Viewer::CellMeshContent wants them
  std::vector<float> points, normals;  ///< x y z of each point
  bool faceted = false;                ///< faces are shaded by their own normals

  std::int32_t pointCount() const { return static_cast<std::int32_t>(points.size() / 3); }
  std::int32_t addPoint(glm::vec3 point, glm::vec3 normal);
  /// Counter-clockwise from outside.
  void addFace(std::span<const std::int32_t> loop, Viewer::Rgb colour);
  void setColour(std::int32_t face, Viewer::Rgb colour);
};

/// A control mesh under a chain of steps.
struct Surface {
  Far::Refinement refinement;
  std::vector<float> points;  ///< of the last level, its vertices first
};

/// Errors: those of Topology::create and refine.
Result<Surface> refine(const Shape& shape, std::span<const Far::Scheme> chain, bool limits = false);

/// How the faces of refined meshes are shaded.
enum class Shading : std::uint8_t {
  smooth,  ///< by the limit normals of the vertices
  faceted
};

/// The last level of a surface. Faces have the colours of their side counts and origins. Smooth shading needs limits.
Result<Model> modelOf(const Surface& surface, Shading shading);

/// The last level of the shape under the chain; the shape itself, faceted, where the chain is empty. Faces have the
/// colours of their side counts and origins. An error of the chain is passed on.
Result<Model> refined(const Shape& shape, const Result<std::vector<Far::Scheme>>& chain,
                      Shading shading = Shading::smooth);

/// `levels` times the same step. An error is passed on.
Result<std::vector<Far::Scheme>> steps(const Result<Far::Scheme>& scheme, std::int32_t levels);

}  // namespace honeycomb::Gallery
