#pragma once

#include <span>
#include <string_view>

#include "apps/viewer/cell_colours.h"
#include "apps/viewer/style.h"

namespace honeycomb::Viewer {

/// A way to look at a surface.
struct Look {
  std::string_view name;
  std::string_view help;
  Colouring colouring;
  bool faceted;   ///< faces by their own normals; else by limit normals
  bool edges;     ///< are cells outlined, unless something else is asked for?
  bool flatness;  ///< coloured by how far from flat faces are
};

/// All of them; a new one is a line of the table in look.cpp.
std::span<const Look> looks();

/// The style a look has; `edges` says whether cells are outlined.
Style styleOf(const Look& look, bool edges);

/// How far from flat the worst face is: the largest distance of a corner from the plane through the middle of its face
/// with Newell's normal, over twice that of the farthest corner from the middle. 0 for flat faces, at most 0.5. Which
/// face is it? Linear, parallel.
struct Bend {
  float most = 0;
  std::int32_t face = -1;
};
Bend flatness(const Far::Topology& topology, std::span<const float> points);

}  // namespace honeycomb::Viewer
