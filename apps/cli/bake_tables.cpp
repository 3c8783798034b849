#include "apps/cli/bake_tables.h"

#include <fmt/format.h>

#include <algorithm>

namespace honeycomb::Cli {
namespace {

/// Was the file made for this mesh?
Result<void> checkMesh(const std::string& file, const Io::TableFile& table, const MeshInput& input) {
  const Far::Polygons& polygons = input.mesh.polygons;
  const auto refuse = [&](const std::string& why) {
    return fail(ErrorCode::invalidMesh,
                fmt::format("{}: {}; make it for this one: honeycomb table build {} {}", file, why, input.file, file));
  };
  if (table.controlPoints() != polygons.vertexCount)
    return refuse(
        fmt::format("reads {} control points, and {} has {}", table.controlPoints(), input.file, polygons.vertexCount));
  if (table.info().meshHash != Io::meshHash(polygons))
    return refuse(fmt::format("was made for another mesh than {}", input.file));
  return {};
}

}  // namespace

Result<BakeTables> BakeTables::build(const SurfacePlan& plan, const RunShape& shape) {
  Result<Far::Refinement> refinement = buildTables(plan, shape);
  if (!refinement) return tl::unexpected(refinement.error());
  BakeTables tables;
  tables.refinement_ = std::move(*refinement);
  const Far::Topology& last = tables.refinement_->last().topology;
  tables.mesh_.vertexCount = last.vertexCount();
  tables.mesh_.faceOffsets = last.faceOffsets();
  tables.mesh_.faceVertices = last.vert();
  tables.levels_ = plan.mesh.chain.levels();
  tables.steps_ = stepNames(plan.mesh.chain);
  return tables;
}

Result<BakeTables> BakeTables::open(const std::string& file, const MeshInput& input) {
  const Result<Io::TableFile> opened = Io::TableFile::open(file);
  if (!opened) return tl::unexpected(opened.error());
  if (const auto same = checkMesh(file, *opened, input); !same) return tl::unexpected(same.error());
  // What is proven here isn't proven again.
  if (const auto levels = opened->levels(); !levels) return tl::unexpected(levels.error());
  const Result<Io::TableMesh> mesh = opened->mesh();
  if (!mesh) return tl::unexpected(mesh.error());
  const Result<const Far::TileTable*> tiles = opened->tiles();
  if (!tiles) return tl::unexpected(tiles.error());
  BakeTables tables;
  tables.file_ = *opened;
  tables.mesh_ = *mesh;
  tables.levels_ = opened->levelCount();
  tables.steps_ = opened->info().steps;
  const bool inOrder = *tiles != nullptr && (*tiles)->order == Far::TileOrder::levels;
  if (inOrder && (*tiles)->lastLevel == opened->levelCount()) tables.tiles_ = *tiles;
  return tables;
}

SurfaceTables BakeTables::view() const {
  return refinement_ ? SurfaceTables(*refinement_) : SurfaceTables(*file_->levels(), mesh_.vertexCount, tiles_);
}

std::vector<std::string> describeSteps(const SchemeChain& chain, const ChainRequest& request,
                                       const SchemeOptions& options) {
  std::vector<std::string> steps = stepNames(chain);
  for (std::string& step : steps) {
    const auto makes = [&](const ChainPart& part) { return part.scheme->name == step; };
    const auto part = std::ranges::find_if(request.parts, makes);
    if (part == request.parts.end()) continue;  // a conversion, which has no options
    if (!part->boundary.empty()) step += fmt::format(" --boundary {}", part->boundary);
    for (const SchemeOption* option : part->scheme->options) {
      if (option->name == kBoundaryOption.name) continue;
      const std::string text = options.text(*option);
      if (!text.empty()) step += fmt::format(" {} {}", option->name, text);
    }
  }
  return steps;
}

}  // namespace honeycomb::Cli
