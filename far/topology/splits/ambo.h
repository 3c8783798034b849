#pragma once

#include "far/topology/split.h"

namespace honeycomb::Far {

/// The split of Finn's midpoint method: a vertex for every edge; every face gives a face through the middles of its
/// edges, every vertex a face round it.
///     closed: H' = 2H, V' = E, F' = F + V
/// A boundary vertex with two faces or more gives a face closed by one boundary edge, one with a single face none.
/// Errors: tooLarge; invalidMesh, the vertex as element, when an inside vertex has two edges.
Split ambo();

}  // namespace honeycomb::Far
