#pragma once

#include "far/topology/split.h"

namespace honeycomb::Far {

/// The split of Doo-Sabin and of Finn's centroid method: every face gives a face of the same number of sides inside it,
/// every edge a quad, every vertex a face of its number of edges.
///     closed: H' = 4H, V' = H, F' = F + E + V
/// At a boundary, edges on it and vertices on it make nothing.
/// Errors: tooLarge; invalidMesh, the vertex as element, when an inside vertex has two edges.
Split expand();

}  // namespace honeycomb::Far
