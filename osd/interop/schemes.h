#pragma once

#include <cstdint>

#include "far/schemes/scheme.h"

namespace honeycomb::Osd {

/// What OpenSubdiv does along a boundary. Vertices tagged as corners stay where they are under both.
enum class BoundaryInterpolation : std::uint8_t {
  edges,           ///< the boundary is a smooth curve of its own: EDGE_ONLY, Blender's "All"
  edgesAndCorners  ///< the same, and vertices in one face alone are corners that stay: EDGE_AND_CORNER, Blender's "Keep
                   ///< Corners", the default of USD
};

/// The options of OpenSubdiv's schemes that are passed on.
struct OpenSubdivOptions {
  BoundaryInterpolation boundary = BoundaryInterpolation::edges;
};

/// One level of Catmull-Clark subdivision by OpenSubdiv's own topology and stencil tables, as a first level before
/// honeycomb schemes: a face of N sides becomes N quads. Vertices are numbered as OpenSubdiv numbers them; face f's
/// children follow each other.
///
/// Errors of its split: tooLarge past 2^31 - 1 half-edges; unsupported for faces or vertices of more sides or edges
/// than OpenSubdiv takes (65,535). It has no rule for creases, and its limits are not known: refine() refuses creases
/// that are sharp when it comes, and limits where it comes last.
Far::Scheme catmullClark(const OpenSubdivOptions& options = {});

/// The same of Loop subdivision: a triangle becomes four. Errors also: unsupported, with the face as element, for a
/// face that is not a triangle.
Far::Scheme loop(const OpenSubdivOptions& options = {});

}  // namespace honeycomb::Osd
