#include "apps/cli/mesh_input.h"

#include <fmt/format.h>

#include <algorithm>

#include "apps/cli/console.h"
#include "apps/cli/formats.h"
#include "far/base/index.h"

namespace honeycomb::Cli {
namespace {

std::vector<std::int32_t> cornersPerVertex(const Far::Polygons& polygons) {
  std::vector<std::int32_t> count(at(polygons.vertexCount), 0);
  for (const std::int32_t v : polygons.indices) ++count[at(v)];
  return count;
}

/// Removes the vertices of no face; the others keep their order.
void dropIsolated(MeshInput& input) {
  Io::ObjMesh& mesh = input.mesh;
  const std::vector<std::int32_t> corners = cornersPerVertex(mesh.polygons);
  if (std::find(corners.begin(), corners.end(), 0) == corners.end()) return;
  std::vector<std::int32_t> renumbered(corners.size(), -1);
  for (std::int32_t v = 0; v < input.fileVertices; ++v) {
    if (corners[at(v)] == 0) continue;
    const std::size_t k = input.kept.size();
    renumbered[at(v)] = static_cast<std::int32_t>(k);
    std::copy_n(mesh.positions.begin() + 3 * std::ptrdiff_t{v}, 3,
                mesh.positions.begin() + 3 * static_cast<std::ptrdiff_t>(k));
    mesh.vertexLines[k] = mesh.vertexLines[at(v)];
    input.kept.push_back(v);
  }
  for (std::int32_t& v : mesh.polygons.indices) v = renumbered[at(v)];
  mesh.polygons.vertexCount = static_cast<std::int32_t>(input.kept.size());
  mesh.positions.resize(3 * input.kept.size());
  mesh.vertexLines.resize(input.kept.size());
}

/// The same defect in the numbers of the file, which start at 1.
Far::Defect inFileNumbers(const MeshInput& input, Far::Defect defect) {
  for (std::int64_t* face : {&defect.face, &defect.otherFace})
    if (*face >= 0) ++*face;
  for (std::int64_t* vertex : {&defect.vertex, &defect.vertex2})
    if (*vertex >= 0) *vertex = input.fileVertex(*vertex) + 1;
  return defect;
}

}  // namespace

Result<MeshInput> readMesh(const std::string& file, Isolated isolated) {
  const Result<const MeshFormat*> format = meshFormat(file);
  if (!format) return tl::unexpected(format.error());
  Result<Io::ObjMesh> mesh = (*format)->read(file);
  if (!mesh) return tl::unexpected(inFile(file, mesh.error()));
  MeshInput input{file, std::move(*mesh), 0, {}};
  input.fileVertices = input.mesh.polygons.vertexCount;
  if (isolated == Isolated::drop) dropIsolated(input);
  return input;
}

DefectReport report(const MeshInput& input, const Far::Defect& defect) {
  const Far::Defect numbered = inFileNumbers(input, defect);
  DefectReport result;
  result.line = defect.face >= 0 ? input.mesh.faceLines[at(defect.face)] : input.mesh.vertexLines[at(defect.vertex)];
  result.face = std::max<std::int64_t>(numbered.face, 0);
  result.vertex = std::max<std::int64_t>(numbered.vertex, 0);
  result.what = Far::describe(numbered);
  result.remedy = Far::remedy(defect.kind);
  if (defect.kind == Far::DefectKind::isolatedVertex) result.remedy += " or pass --drop-isolated";
  return result;
}

Error summarize(const MeshInput& input, const std::vector<Far::Defect>& defects) {
  const DefectReport first = report(input, defects.front());
  const auto count = static_cast<std::int64_t>(defects.size());
  const std::string all = count == 1 ? "the only defect"
                                     : fmt::format("the first of {}, 'honeycomb info {}' lists them all",
                                                   counted(count, "defect"), input.file);
  return {ErrorCode::invalidMesh,
          fmt::format("{}:{}: {} (numbers count from 1, as in the file): {}; {}", input.file, first.line, first.what,
                      first.remedy, all),
          first.line};
}

Result<Far::Topology> makeTopology(const MeshInput& input) {
  Result<Far::Topology> topology = Far::Topology::create(input.mesh.polygons);
  if (topology) return topology;
  // Only the list has numbers that can be carried over to the file's.
  const std::vector<Far::Defect> defects = Far::findDefects(input.mesh.polygons);
  return tl::unexpected(defects.empty() ? inFile(input.file, topology.error()) : summarize(input, defects));
}

Error inFile(const std::string& file, Error error) {
  if (error.message.find(file) == std::string::npos) error.message = file + ": " + error.message;
  return error;
}

void tagCorners(Far::Polygons& polygons) {
  const std::vector<std::int32_t> corners = cornersPerVertex(polygons);
  for (std::int32_t v = 0; v < polygons.vertexCount; ++v)
    if (corners[at(v)] == 1) polygons.corners.push_back(v);
}

}  // namespace honeycomb::Cli
