#pragma once

#include <cstdint>

#include "apps/cli/chain.h"
#include "apps/cli/surface_evaluator.h"
#include "far/base/result.h"
#include "far/tables/refinement.h"

namespace honeycomb::Cli {

/// Can the limit surface of the chain be cut into triangles: is its last scheme one with patches, whose weights are
/// the surface's own? Errors: invalidOption.
Result<void> checkTessellation(const ChainRequest& request, const SchemeOptions& options, std::int32_t pieces);

/// The refinement with one more level, which every evaluator applies as it does the others: the limit surface of the
/// last level, each patch cut into `pieces` x `pieces` triangles. With normals the level's points are [vertices |
/// derivatives du | derivatives dv], and its triangles are made from the
/// vertices whose patches they cut. Errors: invalidMesh, tooLarge past `memory` bytes.
Result<Far::Refinement> tessellate(Far::Refinement refinement, std::int32_t pieces, Normals normals,
                                   std::int64_t memory);

/// Unit normals du x dv of the vertices of such a level; zero where the derivatives are parallel. Parallel.
template <class Real>
void setNormals(Surface<Real>& surface);

}  // namespace honeycomb::Cli
