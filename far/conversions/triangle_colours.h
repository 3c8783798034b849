#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "far/topology/topology.h"

namespace honeycomb::Far {

/// Functions on the vertices of a closed triangle mesh that sum to 0 over every triangle, one basis function each.
struct NullFunction {
  std::vector<std::int32_t> vertices;  ///< of one component, ascending
  std::vector<std::int8_t> values;     ///< one each
  std::int32_t pivot = 0;              ///< a vertex with a value; no other function of the basis has one there
};

/// A basis of them: carries three colours from triangle to triangle over each component's edges; wherever a way round
/// comes back with other colours, those must have equal values. Linear in the triangles.
std::vector<NullFunction> nullFunctions(const Topology& triangles);

}  // namespace honeycomb::Far
