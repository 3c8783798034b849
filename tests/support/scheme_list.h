#pragma once

#include <functional>
#include <string>
#include <vector>

#include "far/schemes/scheme.h"
#include "far/tables/refinement.h"

namespace honeycomb::Test {

/// A way to refine, by the name that failures show.
struct ListedScheme {
  std::string name;
  std::function<Result<std::vector<Far::Scheme>>(const Far::Topology& control, std::int32_t levels)> chain;
  bool threeEdges = false;  ///< refuses inside vertices with two edges
};

/// Has an inside vertex two edges?
bool hasTwoValentVertex(const Far::Topology& topology);

/// Every scheme with its boundary rules and choices of weights, all of which have non-negative weights.
const std::vector<ListedScheme>& listedSchemes();

/// Levels of a listed scheme; throws what goes wrong. Conversions count as levels of their own.
Far::Refinement refinedBy(const ListedScheme& scheme, const Far::Topology& control, std::int32_t levels,
                          bool limits = false);

}  // namespace honeycomb::Test
