#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "apps/cli/chain.h"
#include "far/base/result.h"
#include "far/tables/refinement.h"

namespace honeycomb::Cli {

/// Bytes a run may take: what the system says is available, less a margin. The largest number where it doesn't say.
std::int64_t availableMemory();

/// What a run keeps besides its tables.
struct RunShape {
  int framesAtOnce = 1;
  int bytesPerNumber = 4;
  bool normals = false;
  bool centralPoints = false;  ///< the control faces have central control vertices of their own
  bool fastNormals = false;
};

/// What a mesh of the chain takes.
struct LevelSize {
  Far::LevelCounts counts;
  std::int32_t level = 0;       ///< as the user counts them: a conversion has the level of the mesh it converts
  std::string step;             ///< the scheme that makes it; empty for the control mesh
  std::int64_t pointBytes = 0;  ///< one frame of its points
  std::int64_t runBytes = 0;    ///< a whole run to this level: all tables and buffers
};
/// Of the control mesh and what each step makes.
std::vector<LevelSize> predictSizes(const Far::Topology& control, const SchemeChain& chain, const RunShape& shape);

/// Half-edges a level may have: their numbers are 32-bit.
constexpr std::int64_t kMostHalfEdges = 2147483647;

/// Errors: tooLarge, naming the first level that can't be and its bytes, before anything is allocated.
Result<void> checkSizes(std::span<const LevelSize> sizes, std::int64_t memory);

/// The same of the meshes of a chain, for what memory there is: a ChainCheck.
Result<void> checkChain(const Far::Topology& control, const SchemeChain& chain);

}  // namespace honeycomb::Cli
