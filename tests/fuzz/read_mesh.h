#pragma once

#include "far/base/result.h"
#include "io/mesh.h"
#include "tests/fuzz/targets.h"

namespace honeycomb::Fuzz {

/// Holds what a reader gave to what readers promise, and makes a topology of its polygons.
void useMesh(const Result<Io::Mesh>& mesh);

}  // namespace honeycomb::Fuzz
