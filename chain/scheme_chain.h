#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "chain/schemes.h"
#include "far/base/result.h"
#include "far/schemes/scheme.h"
#include "far/topology/topology.h"

namespace honeycomb::Chain {

/// Consecutive levels of one scheme.
struct ChainPart {
  const SchemeEntry* scheme = nullptr;
  std::int32_t levels = 0;
  std::string_view boundary;  ///< one of the scheme's boundaries; empty where it has none
};

/// What --scheme, --levels and the schemes' options ask for, whatever the mesh.
struct ChainRequest {
  std::vector<ChainPart> parts;
  std::int32_t levels = 0;  ///< of all parts
};

/// How many levels a command takes when --levels isn't given, and the least that can be.
struct LevelChoice {
  std::int32_t usual = 2;
  std::int32_t least = 1;
};

/// Reads "NAME" or "NAME:LEVELS,NAME:LEVELS,...", whose levels add up. Errors: invalidOption for what can't be read, an
/// unknown scheme, too many levels, --levels that contradict a chain, and options that no scheme of the chain has.
Result<ChainRequest> readChain(const SchemeOptions& options, std::optional<std::int32_t> levels,
                               const LevelChoice& choice = {});

/// The steps of a refinement. A conversion that half-box splines need makes a step but no level, so that level L is
/// what L levels of the schemes make.
struct SchemeChain {
  std::vector<Far::Scheme> steps;
  std::vector<std::int32_t> levelOf{0};  ///< the level that steps 0 .. k-1 lead to, for k = 0 .. steps.size()

  std::int32_t levels() const { return levelOf.back(); }
};

/// Can the meshes that a chain makes of a control mesh be built? Else an error.
using ChainCheck = std::function<Result<void>(const Far::Topology& control, const SchemeChain& chain)>;

/// Makes the steps for a control mesh. `fits` is asked before meshes in between are built, which schemes behind the
/// first look at. Errors: those of the schemes and of `fits`; of the first scheme, elements are those of the mesh.
Result<SchemeChain> makeChain(const ChainRequest& request, const SchemeOptions& options, const Far::Topology& control,
                              const ChainCheck& fits);

/// Tags vertices that lie in one face only, so that the brick boundary keeps them where they are, if --corners asks
/// for it. Vertices of faces that are out of range are passed over: Topology::create names them.
void tagCorners(const SchemeOptions& options, Far::Polygons& polygons);

/// "akleman", "half-box", "half-box": what makes each step.
std::vector<std::string> stepNames(const SchemeChain& chain);

}  // namespace honeycomb::Chain
