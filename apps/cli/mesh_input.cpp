#include "apps/cli/mesh_input.h"

#include <fmt/format.h>

#include <algorithm>

#include "apps/cli/console.h"
#include "apps/cli/formats.h"
#include "apps/cli/paired_input.h"
#include "apps/cli/split_input.h"
#include "far/base/index.h"
#include "io/mesh_sequence.h"
#include "io/scene/scene.h"

namespace honeycomb::Cli {
namespace {

/// `width` numbers for each vertex of `order`.
template <class Number>
std::vector<Number> gathered(const std::vector<Number>& values, const std::vector<std::int32_t>& order,
                             std::size_t width) {
  if (values.empty()) return {};
  std::vector<Number> result(width * order.size());
  for (std::size_t k = 0; k < order.size(); ++k) std::copy_n(&values[width * at(order[k])], width, &result[width * k]);
  return result;
}

/// Removes the vertices of no face, but those that a crease names, by mistake; the others keep their order.
void dropIsolated(MeshInput& input) {
  Io::Mesh& mesh = input.mesh;
  std::vector<std::int32_t> mentions = Far::cornersPerVertex(mesh.polygons);
  for (const Far::Crease& crease : mesh.polygons.creases)
    mentions[at(crease.vertex0)] = mentions[at(crease.vertex1)] = 1;
  if (std::find(mentions.begin(), mentions.end(), 0) == mentions.end()) return;
  std::vector<std::int32_t> mentioned;
  for (std::int32_t v = 0; v < input.mesh.polygons.vertexCount; ++v) {
    if (mentions[at(v)] != 0) mentioned.push_back(v);
  }
  input.isolated = input.mesh.polygons.vertexCount - static_cast<std::int64_t>(mentioned.size());
  renumberVertices(input, mentioned);
}

/// The same defect in the numbers of the file, which start at 1.
Far::Defect inFileNumbers(const MeshInput& input, Far::Defect defect) {
  for (std::int64_t* face : {&defect.face, &defect.otherFace})
    if (*face >= 0) ++*face;
  for (std::int64_t* vertex : {&defect.vertex, &defect.vertex2})
    if (*vertex >= 0) *vertex = input.fileVertex(*vertex) + 1;
  return defect;
}

/// 0 where the format has no lines.
std::int64_t lineAt(const std::vector<std::int64_t>& lines, std::int64_t element) {
  return lines.empty() ? 0 : lines[at(element)];
}

/// The line of the tag that a defect is about, or else of its face or vertex.
std::int64_t lineOf(const Io::Mesh& mesh, const Far::Defect& defect) {
  const bool crease = defect.kind == Far::DefectKind::creaseSharpness ||
                      defect.kind == Far::DefectKind::creaseConflict ||
                      defect.kind == Far::DefectKind::creaseWithoutEdge;
  for (std::size_t i = 0; crease && i < mesh.creaseLines.size(); ++i) {
    const Far::Crease& c = mesh.polygons.creases[i];
    if (std::minmax<std::int64_t>(c.vertex0, c.vertex1) == std::minmax(defect.vertex, defect.vertex2))
      return mesh.creaseLines[i];
  }
  for (std::size_t i = 0; defect.kind == Far::DefectKind::cornerNotOnBoundary && i < mesh.cornerLines.size(); ++i)
    if (mesh.polygons.corners[i] == defect.vertex) return mesh.cornerLines[i];
  return defect.face >= 0 ? lineAt(mesh.faceLines, defect.face) : lineAt(mesh.vertexLines, defect.vertex);
}

Result<MeshInput> readFile(const std::string& file) {
  const Result<ReadMesh> read = meshReader(file);
  if (!read) return tl::unexpected(read.error());
  Result<Io::Mesh> mesh = (*read)(file);
  if (!mesh) return tl::unexpected(inFile(file, mesh.error()));
  MeshInput input;
  input.file = file;
  input.mesh = std::move(*mesh);
  return input;
}

/// What only scenes have, asked of another file. Errors: invalidOption.
Result<void> checkNoScene(const std::string& file, const ReadOptions& options) {
  const char* option = !options.clip.empty()   ? "--clip"
                       : !options.node.empty() ? "--node"
                       : options.weld          ? "--weld"
                                               : nullptr;
  if (!option) return {};
  return fail(ErrorCode::invalidOption,
              fmt::format("{}: is for scenes ({}), and {} is none", option, Io::sceneFormatNames(), file));
}

Result<MeshInput> readScene(const std::string& file, const ReadOptions& options) {
  const Result<Io::Scene> scene = Io::Scene::open(file);
  if (!scene) return tl::unexpected(inFile(file, scene.error()));
  Io::SceneRequest request{options.clip, options.node, options.framesPerSecond};
  if (options.weld) request.weld = *options.weld;
  Result<Io::SceneMesh> mesh = scene->mesh(request);
  if (!mesh) return tl::unexpected(inFile(file, mesh.error()));
  MeshInput input;
  input.file = file;
  input.mesh = std::move(mesh->mesh);
  input.frames = std::move(mesh->frames);
  input.files = scene->files();
  input.notes = scene->notes();
  input.clips = scene->clips();
  input.nodes = scene->nodes();
  input.notes.insert(input.notes.end(), mesh->notes.begin(), mesh->notes.end());
  return input;
}

/// The mesh is that of the first file, and is named by it in messages.
Result<MeshInput> readSequence(const std::string& pattern) {
  auto files = Io::sequenceFiles(pattern);
  if (!files) return tl::unexpected(files.error());
  Result<MeshInput> input = readFile(files->front().string());
  if (!input) return input;
  const Result<ReadMesh> read = meshReader(files->front());
  if (!read) return tl::unexpected(read.error());
  input->files = *files;
  input->frames = std::make_shared<const Io::MeshSequence>(std::move(*files), input->mesh, *read);
  return input;
}

Result<MeshInput> readAny(const std::string& file, const ReadOptions& options) {
  const bool sequence = Io::isSequence(file);
  if (!sequence && Io::isSceneFile(file)) return readScene(file, options);
  if (const auto sensible = checkNoScene(file, options); !sensible) return tl::unexpected(sensible.error());
  return sequence ? readSequence(file) : readFile(file);
}

}  // namespace

Result<MeshInput> readMesh(const std::string& file, const ReadOptions& options) {
  auto input = readAny(file, options);
  if (!input) return input;
  input->fileVertices = input->mesh.polygons.vertexCount;
  input->framesPerSecond = options.framesPerSecond;
  if (options.splitNonManifold) splitNonManifold(*input);
  if (options.quads) pairTriangles(*input);
  if (options.dropIsolated) dropIsolated(*input);
  return input;
}

void printNotes(const Session& session, const MeshInput& input) {
  for (const std::string& note : input.notes) printNote(session, fmt::format("{}: {}", input.file, note));
}

std::string placeInFile(const MeshInput& input, std::int64_t line) {
  return line > 0 ? fmt::format("{}:{}", input.file, line) : input.file;
}

std::string_view countedAs(const MeshInput& input) {
  return input.mesh.vertexLines.empty() ? ", vertices as joined" : ", as in the file";
}

DefectReport report(const MeshInput& input, const Far::Defect& defect) {
  const Far::Defect numbered = inFileNumbers(input, defect);
  DefectReport result;
  result.line = lineOf(input.mesh, defect);
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
          fmt::format("{}: {} (numbers count from 1{}): {}; {}", placeInFile(input, first.line), first.what,
                      countedAs(input), first.remedy, all),
          first.line};
}

Result<Far::Topology> makeTopology(const MeshInput& input, Far::FaceOrder order) {
  Result<Far::Topology> topology = Far::Topology::create(input.mesh.polygons, order);
  if (topology) return topology;
  // Only the list has numbers that can be carried over to the file's.
  const std::vector<Far::Defect> defects = Far::findDefects(input.mesh.polygons);
  return tl::unexpected(defects.empty() ? inFile(input.file, topology.error()) : summarize(input, defects));
}

void gatherVertices(MeshInput& input, const std::vector<std::int32_t>& order) {
  std::vector<std::int32_t> kept;
  kept.reserve(order.size());
  for (const std::int32_t v : order) kept.push_back(static_cast<std::int32_t>(input.fileVertex(v)));
  input.kept = std::move(kept);
  Io::Mesh& mesh = input.mesh;
  mesh.polygons.vertexCount = static_cast<std::int32_t>(order.size());
  mesh.positions = gathered(mesh.positions, order, 3);
  mesh.colours = gathered(mesh.colours, order, 3);
  mesh.vertexLines = gathered(mesh.vertexLines, order, 1);
}

void renumberVertices(MeshInput& input, const std::vector<std::int32_t>& order) {
  Far::Polygons& polygons = input.mesh.polygons;
  std::vector<std::int32_t> renumbered(at(polygons.vertexCount), -1);
  for (std::size_t k = 0; k < order.size(); ++k) renumbered[at(order[k])] = static_cast<std::int32_t>(k);
  for (std::int32_t& v : polygons.indices) v = renumbered[at(v)];
  for (std::int32_t& v : polygons.corners) v = renumbered[at(v)];
  for (Far::Crease& crease : polygons.creases) {
    crease.vertex0 = renumbered[at(crease.vertex0)];
    crease.vertex1 = renumbered[at(crease.vertex1)];
  }
  gatherVertices(input, order);
}

Error inFile(const std::string& file, Error error) {
  if (error.message.find(file) == std::string::npos) error.message = file + ": " + error.message;
  return error;
}

Error located(const MeshInput& input, const Error& error) {
  const std::string name = elementName(error.kind, error.element);
  const std::size_t place = error.message.find(name);
  if (error.kind == ElementKind::other || place == std::string::npos) return inFile(input.file, error);
  const bool face = error.kind == ElementKind::face;
  const std::int64_t line = lineAt(face ? input.mesh.faceLines : input.mesh.vertexLines, error.element);
  const std::int64_t number = (face ? error.element : input.fileVertex(error.element)) + 1;
  std::string message = error.message;
  message.replace(place, name.size(), fmt::format("{} {}", face ? "face" : "vertex", number));
  return {error.code,
          fmt::format("{}: {} (numbers count from 1{})", placeInFile(input, line), message, countedAs(input)), line};
}

}  // namespace honeycomb::Cli
