#pragma once

#include <string>
#include <vector>

#include "apps/cli/memory.h"
#include "apps/cli/mesh_input.h"

namespace honeycomb::Cli {

/// A manifold, for `honeycomb info`.
struct MeshReport {
  const MeshInput& input;
  const Far::Topology& topology;
  std::vector<LevelSize> sizes;  ///< predicted, levels 0..
  std::int64_t memory = 0;       ///< bytes a run may take
};
std::string meshText(const MeshReport& report);
std::string meshJson(const MeshReport& report);

/// A mesh with defects, all of which are listed.
struct DefectList {
  const MeshInput& input;
  const std::vector<Far::Defect>& defects;
};
std::string defectsText(const DefectList& list);
std::string defectsJson(const DefectList& list);

}  // namespace honeycomb::Cli
