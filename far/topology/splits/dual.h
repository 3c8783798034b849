#pragma once

#include "far/topology/split.h"

namespace honeycomb::Far {

/// A vertex for each face, a face for each vertex inside; vertices on a boundary make no face, and faces all of whose
/// vertices are on a boundary no vertex.
/// Errors: invalidMesh when nothing is left, with the vertex as element when an inside vertex has fewer than three
/// faces, with the face as element when its inside vertices lie apart, so that the faces they become would meet in a
/// bow-tie.
Split dualSplit();

}  // namespace honeycomb::Far
