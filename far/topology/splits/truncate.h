#pragma once

#include "far/topology/split.h"

namespace honeycomb::Far {

/// The split of Finn's trisection: two vertices on every edge; every face gives one of twice its sides, every vertex a
/// face where it is cut off.
///     closed: H' = 3H, V' = H, F' = F + V; after it all vertices have three edges
/// A boundary vertex with two faces or more gives a face closed by one boundary edge, one with a single face none.
/// Errors: tooLarge; invalidMesh, the vertex as element, when an inside vertex has two edges.
Split truncate();

}  // namespace honeycomb::Far
