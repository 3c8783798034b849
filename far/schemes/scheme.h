#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "far/schemes/source_level.h"
#include "far/topology/split.h"

namespace honeycomb::Far {

/// The stencil of a whole N-gon, in the form all schemes of the family share. The new point i of the face is
///     sum_k c_k p_{i+k} + central q,
///     c_k = [k=0] here + [k=1] next + [k=N/2] opposite + mean + cosine cos(2 pi k/N) + sine sin(2 pi k/N)
/// with q the central control vertex of the face (its barycentre where the level has none), so that a row, its
/// even/odd parts, its projections and its mirrored halves all follow from a few numbers. `opposite` is for even N up
/// to kLargestCirculant.
struct CirculantRule {
  double here = 0, next = 0, mean = 0, cosine = 0, sine = 0, central = 0, opposite = 0;
};

/// c_0 .. c_{N-1} of a rule.
std::vector<double> firstRow(const CirculantRule& rule, std::int32_t sides);

/// How the corner points of half faces (brick boundary) are found.
enum class HalfFaces : std::uint8_t {
  mirrored,  ///< by faceRule on the polygon completed by its mirror image
  ownRows    ///< by pointRow
};

/// Where the limit position and normal of a vertex are found.
enum class VertexLimits : std::uint8_t {
  childFace,   ///< in the face it becomes at the next level
  patchCentre  ///< in the middle of the half-box patch of its three faces
};

/// How a scheme keeps edges sharp: the mesh is cut open along them, and refined by a split whose boundary points depend
/// on the boundary alone, so that the two sides of a cut stay together.
struct CreaseRule {
  /// For which creases there is a rule.
  enum class Reach : std::uint8_t {
    none,      ///< the scheme has no rule for creases
    infinite,  ///< only for creases that stay sharp for ever
    any        ///< for any sharpness: the split's cut faces can grow together again
  };
  Reach reach = Reach::none;
  bool borders = false;  ///< `split` is also the scheme's own: the mesh may have borders beside its creases
  Split split = {};      ///< of meshes that are cut open
};

/// A subdivision scheme as a value: which split, and the weights of its few stencil shapes. Made by the functions of
/// far/schemes, one file a scheme; copied freely. The functions are called from several threads at once.
struct Scheme {
  std::string name;
  Split split;
  /// The refined level has a central control vertex for each face.
  bool centralPoints = false;
  /// Stencil of the corner points of whole faces with that many sides; of splits that have corner points.
  std::function<CirculantRule(std::int32_t sides)> faceRule;
  HalfFaces halfFaces = HalfFaces::mirrored;
  /// What the rows of ownRows read of a face of the parent of more than kLargestCirculant sides in place of all its
  /// corners: sums, whose numbers follow SourceLevel::sumPoint(f); none: they read few corners.
  std::function<std::vector<Row>(const Topology& parent, std::int32_t f)> faceSums;
  /// Appends the stencil of a new point that is not a corner point of a whole face.
  std::function<void(const SourceLevel& parent, const NewPoint& point, Row& row)> pointRow;
  /// Appends the stencil of the central control vertex of face f of the child; of schemes with centralPoints.
  std::function<void(const SourceLevel& parent, const SplitResult& child, std::int32_t f, Row& row)> centralRow;
  /// The weight of a face's central control vertex in the face's limit position; the rest is its barycentre's.
  std::function<double(std::int32_t sides)> limitCentral;
  CreaseRule creases = {};
  VertexLimits vertexLimits = VertexLimits::childFace;
  /// Corners of a clamped boundary of more than 180 degrees have a tangent plane.
  bool smoothCorners = false;
  /// The scheme of all steps after this one, which limits are those of; none: this one.
  std::shared_ptr<const Scheme> after = nullptr;
  /// Indices a refined vertex takes in a level table, about; to predict sizes by.
  std::int32_t entriesPerVertex = 1;
};

}  // namespace honeycomb::Far
