#include "osd/interop/schemes.h"

#include <fmt/format.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/stencilTableFactory.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <limits>
#include <memory>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/tables/level_table.h"
#include "osd/interop/stencil_tables.h"

namespace honeycomb::Osd {

namespace {

namespace Foreign = OpenSubdiv::Far;
using Foreign::TopologyDescriptor;
using Refiner = std::unique_ptr<Foreign::TopologyRefiner>;
using Sdc = OpenSubdiv::Sdc::Options;

struct Rule {
  OpenSubdiv::Sdc::SchemeType type;
  OpenSubdivOptions options;
};

bool isCorner(Far::VertexTag tag) {
  return tag == Far::VertexTag::corner || tag == Far::VertexTag::fixedCorner;
}

std::vector<std::int32_t> cornersOf(const Far::Topology& topology) {
  std::vector<std::int32_t> corners;
  for (const std::int32_t h : topology.boundary()) {
    if (isCorner(topology.vertexTag(topology.vert(h)))) corners.push_back(topology.vert(h));
  }
  return corners;
}

/// What OpenSubdiv would refuse, or get wrong.
Result<void> check(const Far::Topology& parent, const Rule& rule) {
  for (const Far::FaceRun& run : parent.runs()) {
    const std::int32_t face = parent.inputFace(run.firstFace);
    if (rule.type == OpenSubdiv::Sdc::SCHEME_LOOP && run.sides != 3) {
      return fail(
          ErrorCode::unsupported,
          fmt::format("{} has {} sides, and Loop subdivision takes triangles only; use Catmull-Clark, or convert "
                      "the mesh to triangles",
                      elementName(ElementKind::face, face), run.sides),
          face, ElementKind::face);
    }
    if (run.sides > Foreign::VALENCE_LIMIT) {
      return fail(ErrorCode::unsupported,
                  fmt::format("{} has {} sides, and OpenSubdiv takes {}; cut it into smaller faces",
                              elementName(ElementKind::face, face), run.sides, Foreign::VALENCE_LIMIT),
                  face, ElementKind::face);
    }
  }
  std::vector<std::int32_t> valence(at(parent.vertexCount()), 0);
  for (const std::int32_t v : parent.vert()) {
    if (++valence[at(v)] < Foreign::VALENCE_LIMIT) continue;
    return fail(ErrorCode::unsupported,
                fmt::format("{} has {} faces or more, and OpenSubdiv takes less; split it",
                            elementName(ElementKind::vertex, v), Foreign::VALENCE_LIMIT),
                v, ElementKind::vertex);
  }
  if (parent.halfEdgeCount() > std::numeric_limits<std::int32_t>::max() / 4) {
    return fail(ErrorCode::tooLarge,
                fmt::format("{} half-edges would become four times as many, past 2^31 - 1; use fewer levels",
                            parent.halfEdgeCount()));
  }
  return {};
}

/// The topology and one uniform level of refinement, in OpenSubdiv.
Refiner refineOnce(const Far::Topology& parent, const Rule& rule) {
  const std::vector<std::int32_t> corners = cornersOf(parent);
  const std::vector<float> sharpness(corners.size(), OpenSubdiv::Sdc::Crease::SHARPNESS_INFINITE);
  std::vector<int> sides(at(parent.faceCount()));
  for (std::int32_t f = 0; f < parent.faceCount(); ++f) sides[at(f)] = parent.sides(f);
  TopologyDescriptor descriptor;
  descriptor.numVertices = parent.vertexCount();
  descriptor.numFaces = parent.faceCount();
  descriptor.numVertsPerFace = sides.data();
  descriptor.vertIndicesPerFace = parent.vert().data();
  descriptor.numCorners = static_cast<int>(corners.size());
  descriptor.cornerVertexIndices = corners.data();
  descriptor.cornerWeights = sharpness.data();

  Sdc options;
  options.SetVtxBoundaryInterpolation(rule.options.boundary == BoundaryInterpolation::edges
                                          ? Sdc::VTX_BOUNDARY_EDGE_ONLY
                                          : Sdc::VTX_BOUNDARY_EDGE_AND_CORNER);
  using Factory = Foreign::TopologyRefinerFactory<TopologyDescriptor>;
  Refiner refiner(Factory::Create(descriptor, Factory::Options(rule.type, options)));
  if (refiner) refiner->RefineUniform(Foreign::TopologyRefiner::UniformOptions(1));
  return refiner;
}

/// The refined level, whose faces are all of one side count; corners stay corners.
Far::Polygons polygonsOf(const Foreign::TopologyRefiner& refiner, const Far::Topology& parent) {
  const Foreign::TopologyLevel& child = refiner.GetLevel(1);
  const std::int64_t sides = child.GetNumFaces() > 0 ? child.GetFaceVertices(0).size() : 0;
  Far::Polygons polygons;
  polygons.vertexCount = child.GetNumVertices();
  polygons.faceOffsets.resize(at(child.GetNumFaces()) + 1);
  polygons.indices.resize(at(child.GetNumFaces() * sides));
  Parallel::forEach(0, child.GetNumFaces(), [&](std::int64_t f) {
    const Foreign::ConstIndexArray loop = child.GetFaceVertices(static_cast<Foreign::Index>(f));
    polygons.faceOffsets[at(f) + 1] = (f + 1) * sides;
    for (int i = 0; i < loop.size(); ++i) polygons.indices[at(f * sides + i)] = loop[i];
  });
  for (const std::int32_t v : cornersOf(parent)) {
    polygons.corners.push_back(refiner.GetLevel(0).GetVertexChildVertex(v));
  }
  return polygons;
}

/// The refined level, its faces the children of those of the level before. Being of one side count, they are numbered
/// as they are in OpenSubdiv.
Far::Topology withParents(Far::Topology sorted, const Foreign::TopologyLevel& child) {
  Far::TopologyArrays arrays = std::move(sorted).arrays();
  Parallel::forEach(0, static_cast<std::int64_t>(arrays.parents.size()), [&](std::int64_t f) {
    arrays.parents[at(f)] = child.GetFaceParentFace(static_cast<Foreign::Index>(f));
  });
  return Far::Topology(std::move(arrays));
}

Result<std::shared_ptr<const Far::LevelTable>> tableOf(const Foreign::TopologyRefiner& refiner) {
  using Factory = Foreign::StencilTableFactoryReal<double>;
  Factory::Options options;
  options.generateIntermediateLevels = false;
  options.generateOffsets = true;
  options.maxLevel = 1;
  const std::unique_ptr<const Foreign::StencilTableReal<double>> stencils(Factory::Create(refiner, options));
  Result<Far::LevelTable> table = fromOpenSubdiv(*stencils);
  if (!table) return tl::unexpected(table.error());
  return std::make_shared<const Far::LevelTable>(std::move(*table));
}

Result<Far::SplitResult> apply(const Far::Topology& parent, const Rule& rule) {
  if (auto sound = check(parent, rule); !sound) return tl::unexpected(sound.error());
  const Refiner refiner = refineOnce(parent, rule);
  if (!refiner) return fail(ErrorCode::unsupported, "OpenSubdiv refuses the mesh; use another first level");
  Result<Far::Topology> sorted = Far::Topology::create(polygonsOf(*refiner, parent));
  if (!sorted) return tl::unexpected(sorted.error());
  auto table = tableOf(*refiner);
  if (!table) return tl::unexpected(table.error());
  return Far::SplitResult{withParents(std::move(*sorted), refiner->GetLevel(1)), 0, {}, std::move(*table)};
}

/// V' = V + E (+ F), E' = 2E + H (Loop: 2E + 3F, the same), F' = H (4F), H' = 4H.
Far::Census grow(const Far::Census& parent, bool facePoints) {
  Far::Census child;
  child.vertices = parent.vertices + parent.edges + (facePoints ? parent.faces : 0);
  child.edges = 2 * parent.edges + parent.halfEdges;
  child.faces = facePoints ? parent.halfEdges : 4 * parent.faces;
  child.halfEdges = 4 * parent.halfEdges;
  child.boundaryEdges = child.onLine = 2 * parent.boundaryEdges;
  child.corner = parent.corner + parent.fixedCorner;
  child.real = child.boundaryEdges - child.corner;
  child.exact = parent.exact;
  return child;
}

/// Loose rows have weights beside their indices: an entry takes the bytes of four indices.
constexpr std::int32_t kLooseEntry = 4;

Far::Scheme scheme(std::string name, const Rule& rule, std::int32_t entriesPerVertex) {
  const bool facePoints = rule.type == OpenSubdiv::Sdc::SCHEME_CATMARK;
  Far::Scheme result;
  result.split.name = name;
  result.split.apply = [rule](const Far::Topology& parent) { return apply(parent, rule); };
  result.split.grow = [facePoints](const Far::Census& parent) { return grow(parent, facePoints); };
  result.name = std::move(name);
  result.entriesPerVertex = entriesPerVertex;
  return result;
}

}  // namespace

Far::Scheme catmullClark(const OpenSubdivOptions& options) {
  return scheme("catmull-clark", {OpenSubdiv::Sdc::SCHEME_CATMARK, options}, 7 * kLooseEntry);
}

Far::Scheme loop(const OpenSubdivOptions& options) {
  return scheme("loop", {OpenSubdiv::Sdc::SCHEME_LOOP, options}, 5 * kLooseEntry);
}

}  // namespace honeycomb::Osd
