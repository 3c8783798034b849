#include "apps/cli/tessellation.h"

#include <fmt/format.h>

#include "apps/cli/chain.h"
#include "apps/cli/console.h"
#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/tables/patch_table.h"
#include "osd/cpu_kernels.h"

namespace honeycomb::Cli {
namespace {

/// Samples share the vertices of patches: K^2/2 a patch, and as many on edges as there are.
Result<void> checkMemory(const Far::PatchTable& patches, std::int32_t pieces, std::int64_t memory) {
  // Three rows with 13 entries, as patches of hexagons have them; the triangles; x y z and the derivatives.
  constexpr std::int64_t kRow = 13 * (4 + 4 + 8) + 8, kVertex = 3 * kRow + 9 * 8, kTriangle = 3 * 4 * 8;
  const std::int64_t triangles = std::int64_t{patches.patchCount()} * pieces * pieces;
  const std::int64_t bytes = triangles * kTriangle + (triangles / 2 + patches.patchCount()) * kVertex;
  if (bytes <= memory) return {};
  return fail(
      ErrorCode::tooLarge,
      fmt::format("--tessellate {}: {} patches would take about {} ({} bytes) of memory, {} is free; use a lower "
                  "number, or fewer --levels",
                  pieces, grouped(patches.patchCount()), humanBytes(bytes), bytes, humanBytes(memory)));
}

Result<Far::LevelTable> makeTable(const Far::PatchTable& patches, const Far::Tessellation& tessellation,
                                  Normals normals) {
  if (normals != Normals::none) return patches.limitFrames(tessellation.samples);
  Result<Far::LimitStencils> stencils = patches.limitStencils(tessellation.samples);
  if (!stencils) return tl::unexpected(stencils.error());
  return std::move(stencils->positions);
}

/// The triangles, which come patch by patch, as faces made from the vertices whose patches they cut.
Far::Topology madeFromVertices(Far::Topology triangles, const Far::PatchTable& patches, std::int32_t pieces) {
  Far::TopologyArrays arrays = std::move(triangles).arrays();
  for (Far::FaceRun& run : arrays.runs) run.parent = Far::FaceParent::vertex;
  Parallel::forEach(0, static_cast<std::int64_t>(arrays.parents.size()), [&](std::int64_t t) {
    arrays.parents[at(t)] = patches.vertex(arrays.parents[at(t)] / (pieces * pieces));
  });
  return Far::Topology(std::move(arrays));
}

}  // namespace

Result<void> checkTessellation(const ChainRequest& request, const SchemeOptions& options, std::int32_t pieces) {
  const ChainPart& last = request.parts.back();
  if (pieces < 1 || pieces > Far::kMostPieces)
    return fail(ErrorCode::invalidOption,
                fmt::format("--tessellate {}: give a number from 1 to {}", pieces, Far::kMostPieces));
  if (!last.scheme->patches)
    return fail(ErrorCode::invalidOption,
                fmt::format("--tessellate {}: {} has no patches; use half-box, alone or last in a chain", pieces,
                            last.scheme->name));
  const std::string tuned = options.text(kTunedOption);
  if (tuned == "all" || (tuned == "first" && last.levels == 0))
    return fail(ErrorCode::invalidOption,
                fmt::format("--tessellate {}: patches are those of the untuned weights; use --tuned none, or --tuned "
                            "first with --levels 1 or more",
                            pieces));
  if (last.boundary != "natural")
    return fail(ErrorCode::invalidOption,
                fmt::format("--tessellate {}: the patches end at the natural boundary; leave out --boundary {}", pieces,
                            last.boundary));
  return {};
}

Result<Far::Refinement> tessellate(Far::Refinement refinement, std::int32_t pieces, Normals normals,
                                   std::int64_t memory) {
  const Result<Far::PatchTable> patches = Far::PatchTable::build(refinement.last().topology);
  if (!patches) return tl::unexpected(patches.error());
  if (patches->patchCount() == 0)
    return fail(ErrorCode::invalidMesh,
                "no vertex lies inside the mesh, so there is no surface to tessellate; give a "
                "larger mesh");
  if (const auto fits = checkMemory(*patches, pieces, memory); !fits) return tl::unexpected(fits.error());
  const Result<Far::Tessellation> tessellation = patches->tessellate(pieces);
  if (!tessellation) return tl::unexpected(tessellation.error());
  Result<Far::LevelTable> table = makeTable(*patches, *tessellation, normals);
  if (!table) return tl::unexpected(table.error());
  Result<Far::Topology> triangles = Far::Topology::create(tessellation->polygons);
  if (!triangles)
    return fail(ErrorCode::invalidMesh,
                fmt::format("--tessellate {}: the triangles are no manifold, since faces have several edges in common; "
                            "use 2 or more",
                            pieces));
  return std::move(refinement)
      .followedBy(
          {madeFromVertices(std::move(*triangles), *patches, pieces), std::move(*table), Far::CentralPoints::none});
}

template <class Real>
void setNormals(Surface<Real>& surface) {
  const std::size_t size = 3 * at(surface.vertexCount);
  surface.normals.resize(size);
  const Real* du = surface.points.data() + size;
  const Real* dv = du + size;
  Parallel::forEach(0, surface.vertexCount, [&](std::int64_t v) {
    const auto normal = Osd::Kernels::unitNormal(Osd::Kernels::load<3>(du + 3 * v), Osd::Kernels::load<3>(dv + 3 * v));
    Osd::Kernels::store(normal, surface.normals.data() + 3 * v);
  });
}
template void setNormals(Surface<float>&);
template void setNormals(Surface<double>&);

}  // namespace honeycomb::Cli
