// OpenSubdiv as a first level before honeycomb schemes, and stencil tables exchanged with it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opensubdiv/far/stencilTableFactory.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/osd/bufferDescriptor.h>
#include <opensubdiv/osd/cpuEvaluator.h>

#include <algorithm>
#include <cmath>

#include "osd/cpu_evaluator.h"
#include "osd/interop/schemes.h"
#include "osd/interop/stencil_tables.h"
#include "tests/support/random_tables.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"
#include "tests/support/table_rows.h"

namespace honeycomb::Test {
namespace {

namespace Foreign = OpenSubdiv::Far;
using Osd::BoundaryInterpolation;

Far::Refinement chain(const PolyMesh& mesh, const std::vector<Far::Scheme>& schemes,
                      const std::vector<std::size_t>& corners = {}) {
  auto refinement = Far::refine(toTopology(mesh, corners), schemes);
  if (!refinement) throw std::runtime_error(refinement.error().message);
  return std::move(*refinement);
}

/// The vertex of a level that lies at a point, -1 if none does.
std::int32_t vertexAt(const std::vector<Vec3>& points, const Vec3& place) {
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (distance(points[v], place) < 1e-14) return static_cast<std::int32_t>(v);
  }
  return -1;
}

void expectPartition(const Far::LevelTable& table) {
  for (const StencilRow& row : expandRows(table)) {
    double sum = 0;
    for (const auto& [point, w] : row) sum += w;
    ASSERT_NEAR(sum, 1, 1e-14);
  }
}

TEST(CatmullClark, OfACubeIsWhatThePaperSays) {
  const Far::Refinement refinement = chain(cube(), {Osd::catmullClark()});
  const Far::Topology& level = refinement.level(1).topology;
  EXPECT_EQ(level.vertexCount(), 26);
  EXPECT_EQ(level.faceCount(), 24);
  EXPECT_EQ(level.edgeCount(), 48);
  ASSERT_NO_FATAL_FAILURE(expectPartition(refinement.level(1).table));
  std::vector<Vec3> cage = cube().points;
  const Vec3 middle = centroid(cage);
  for (Vec3& p : cage) p = 2 / distance(cage[0], cage[1]) * (p - middle);  // corners at +-1
  const auto points = levelPoints<double>(refinement, 1, cage);
  EXPECT_GE(vertexAt(points, {1, 0, 0}), 0) << "the point of a face";
  EXPECT_GE(vertexAt(points, {0.75, 0, -0.75}), 0) << "the point of an edge: of its ends and two face points";
  EXPECT_GE(vertexAt(points, {5.0 / 9, 5.0 / 9, -5.0 / 9}), 0) << "(Q + 2R + (n-3)S)/n";
}

TEST(CatmullClark, ChildrenKnowTheirParents) {
  const PolyMesh mesh = prism(7);
  const Far::Refinement refinement = chain(mesh, {Osd::catmullClark()});
  const Far::Topology& base = refinement.level(0).topology;
  const auto points = levelPoints<double>(refinement, 1, mesh.points);
  const auto origins = refinement.faceOrigins(1);
  ASSERT_EQ(origins.size(), 2 * 7 + 7 * std::size_t{4});
  std::vector<int> children(static_cast<std::size_t>(base.faceCount()), 0);
  const PolyMesh child = toMesh(refinement.level(1).topology, points);
  const PolyMesh parent = toMesh(base, mesh.points);
  for (std::size_t f = 0; f < origins.size(); ++f) {
    EXPECT_FALSE(origins[f].vertex);
    ++at(children, origins[f].element);
    // A child quad has the face's centroid as one of its corners.
    const Vec3 centre = centroid(corners(parent, static_cast<std::size_t>(origins[f].element)));
    EXPECT_TRUE(std::ranges::any_of(corners(child, f), [&](const Vec3& p) { return distance(p, centre) < 1e-14; }));
  }
  for (std::int32_t f = 0; f < base.faceCount(); ++f) EXPECT_EQ(at(children, f), base.sides(f));
}

TEST(CatmullClark, CornersOfABoundary) {
  const PolyMesh mesh = grid(3, 3);
  const Vec3 corner = mesh.points.front();
  const auto corners = [&](BoundaryInterpolation boundary, const std::vector<std::size_t>& tags) {
    const Far::Refinement refinement =
        chain(mesh, {Osd::catmullClark({boundary}), Osd::catmullClark({boundary})}, tags);
    const auto points = levelPoints<double>(refinement, 2, mesh.points);
    std::vector<bool> stay;
    for (const Vec3& p : {corner, mesh.points.back()}) stay.push_back(vertexAt(points, p) >= 0);
    return stay;
  };
  EXPECT_EQ(corners(BoundaryInterpolation::edges, {}), (std::vector{false, false}));
  EXPECT_EQ(corners(BoundaryInterpolation::edgesAndCorners, {}), (std::vector{true, true}));
  EXPECT_EQ(corners(BoundaryInterpolation::edges, {0}), (std::vector{true, false})) << "a tagged corner";
}

TEST(CatmullClark, RefusesCreases) {
  Far::Polygons polygons = toPolygons(cube());
  polygons.creases = {{polygons.indices[0], polygons.indices[1], 2}};
  const auto control = Far::Topology::create(polygons);
  ASSERT_TRUE(control) << control.error().message;
  const auto refused = Far::refine(*control, Osd::catmullClark(), 1);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::invalidOption);
  EXPECT_THAT(refused.error().message, testing::HasSubstr("catmull-clark has no rule for creases"));
}

TEST(Loop, OfATetrahedronIsWhatTheThesisSays) {
  const PolyMesh mesh = tetrahedron();
  const Far::Refinement refinement = chain(mesh, {Osd::loop()});
  EXPECT_EQ(refinement.level(1).topology.vertexCount(), 10);
  EXPECT_EQ(refinement.level(1).topology.faceCount(), 16);
  ASSERT_NO_FATAL_FAILURE(expectPartition(refinement.level(1).table));
  const auto points = levelPoints<double>(refinement, 1, mesh.points);
  const auto& p = mesh.points;
  EXPECT_GE(vertexAt(points, 0.375 * (p[0] + p[1]) + 0.125 * (p[2] + p[3])), 0) << "3/8 of the ends, 1/8 opposite";
  EXPECT_GE(vertexAt(points, 0.4375 * p[0] + 0.1875 * (p[1] + p[2] + p[3])), 0) << "valence 3: 7/16 and 3/16";
}

TEST(Loop, NamesAFaceThatIsNoTriangle) {
  const auto refused = Far::refine(toTopology(prism(3)), Osd::loop(), 1);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::unsupported);
  EXPECT_THAT(refused.error().message, testing::HasSubstr("has 4 sides"));
  EXPECT_EQ(toTopology(prism(3)).sides(2), 4);
  const PolyMesh mesh = prism(3);
  EXPECT_EQ(at(mesh.faces, refused.error().element).size(), 4U);
}

TEST(Hybrid, HoneycombFollowsEitherScheme) {
  const SchemeCase honeycomb = schemeCase(NamedTension::paper);
  for (const PolyMesh& mesh : {tetrahedron(), wheel(5)}) {
    for (const Far::Scheme& first : {Osd::catmullClark(), Osd::loop()}) {
      SCOPED_TRACE(first.name);
      const std::vector<Far::Scheme> schemes{first, honeycomb.scheme, honeycomb.scheme};
      const Far::Refinement refinement = chain(mesh, schemes);
      const auto predicted = Far::predict(toTopology(mesh), schemes);
      for (std::int32_t k = 0; k <= 3; ++k) {
        const Far::Topology& level = refinement.level(k).topology;
        EXPECT_TRUE(predicted[static_cast<std::size_t>(k)].exact);
        EXPECT_EQ(predicted[static_cast<std::size_t>(k)].vertices, level.vertexCount()) << "level " << k;
        EXPECT_EQ(predicted[static_cast<std::size_t>(k)].halfEdges, level.halfEdgeCount()) << "level " << k;
        EXPECT_EQ(predicted[static_cast<std::size_t>(k)].faces, level.faceCount()) << "level " << k;
      }
      // The same as honeycomb on the refined mesh by itself.
      const PolyMesh middle = levelMesh(refinement, 1, mesh.points);
      const Far::Refinement alone = chain(middle, {honeycomb.scheme, honeycomb.scheme});
      const auto expected = levelPoints<double>(alone, 2, middle.points);
      const auto actual = levelPoints<double>(refinement, 3, mesh.points);
      ASSERT_EQ(actual.size(), expected.size());
      for (std::size_t v = 0; v < expected.size(); ++v) ASSERT_LT(distance(actual[v], expected[v]), 1e-14);
      EXPECT_EQ(refinement.vertexOrigins(3).size(), actual.size());
    }
  }
}

TEST(Hybrid, VectorsAndThreadsGiveTheBitsOfThePlainLoops) {
  for (const Far::Scheme& first : {Osd::catmullClark(), Osd::loop()}) {
    SCOPED_TRACE(first.name);
    const PolyMesh mesh = tetrahedron();
    const Far::Refinement refinement = chain(mesh, {first, schemeCase(NamedTension::paper).scheme});
    for (const std::int32_t length : {2, 3, 4}) {
      const Osd::BufferDescriptor packed{0, length, length};
      const auto control = randomNumbers(packed.extent(refinement.level(0).pointCount()));
      const auto evaluated = [&](Osd::CpuEvaluator evaluator) {
        std::vector<float> out(static_cast<std::size_t>(packed.extent(refinement.last().pointCount())));
        EXPECT_TRUE(
            evaluator.evaluate(refinement, 2, Osd::Points<float>{control, packed}, Osd::PointsOut<float>{out, packed}));
        return out;
      };
      const auto expected = evaluated(Osd::SerialEvaluator());
      EXPECT_EQ(evaluated(Osd::SimdEvaluator()), expected) << "length " << length;
      EXPECT_EQ(evaluated(Osd::TbbEvaluator()), expected) << "length " << length;
    }
  }
}

TEST(Hybrid, LimitsNeedAnotherLastScheme) {
  const SchemeCase honeycomb = schemeCase(NamedTension::paper);
  const Far::Topology topology = toTopology(cube());
  EXPECT_TRUE(Far::refine(topology, std::vector{Osd::catmullClark(), honeycomb.scheme}, {.limits = true}));
  const auto refused = Far::refine(topology, Osd::catmullClark(), 1, {.limits = true});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::unsupported);
  EXPECT_THAT(refused.error().message, testing::HasSubstr("limits of catmull-clark are not known"));
}

std::vector<float> evaluatedByOpenSubdiv(const Foreign::StencilTableReal<float>& table,
                                         const std::vector<float>& control) {
  namespace Device = OpenSubdiv::Osd;
  std::vector<float> out(3 * static_cast<std::size_t>(table.GetNumStencils()));
  const Device::BufferDescriptor desc(0, 3, 3);
  EXPECT_TRUE(Device::CpuEvaluator::EvalStencils(control.data(), desc, out.data(), desc, table.GetSizes().data(),
                                                 table.GetOffsets().data(), table.GetControlIndices().data(),
                                                 table.GetWeights().data(), 0, table.GetNumStencils()));
  return out;
}

void expectNear(const std::vector<float>& a, const std::vector<float>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(a[i], b[i], 2e-6F) << "number " << i;
}

template <class Table>
std::vector<float> evaluatedHere(const Table& table, std::int32_t targets, const std::vector<float>& control) {
  const auto evaluated = [&](Osd::CpuEvaluator evaluator) {
    std::vector<float> out(3 * static_cast<std::size_t>(targets));
    EXPECT_TRUE(evaluator.evaluate(table, Osd::Points<float>{control, {}}, Osd::PointsOut<float>{out, {}}));
    return out;
  };
  const std::vector<float> out = evaluated(Osd::SerialEvaluator());
  EXPECT_EQ(evaluated(Osd::SimdEvaluator()), out);
  EXPECT_EQ(evaluated(Osd::TbbEvaluator()), out);
  return out;
}

TEST(StencilExchange, OpenSubdivEvaluatesOurTables) {
  for (const PolyMesh& mesh : {torus(6, 5), grid(5, 4)}) {
    const Far::Refinement refinement = refined(mesh, schemeCase(NamedTension::paper).scheme, 3, {}, true);
    const std::vector<float> control = pack<float>(mesh.points);
    const auto points = Far::StencilTable::build(refinement);
    const auto limits = Far::StencilTable::build(refinement, {.kind = Far::StencilKind::vertexLimits});
    ASSERT_TRUE(points && limits);
    for (const Far::StencilTable* table : {&*points, &*limits}) {
      const auto theirs = Osd::toOpenSubdiv(*table);
      ASSERT_TRUE(theirs);
      EXPECT_EQ((*theirs)->GetNumControlVertices(), refinement.level(0).topology.vertexCount());
      expectNear(evaluatedByOpenSubdiv(**theirs, control), evaluatedHere(*table, table->rowCount(), control));
    }
    const auto tangents = Osd::toOpenSubdiv(*limits, Far::StencilWeights::tangent1);
    ASSERT_TRUE(tangents);
    EXPECT_THAT((*tangents)->GetWeights(), testing::ElementsAreArray(limits->tangent1Single));
    EXPECT_FALSE(Osd::toOpenSubdiv(*points, Far::StencilWeights::tangent1));
  }
}

/// `levels` of Catmull-Clark, all from the control vertices, as OpenSubdiv's users make them.
std::unique_ptr<const Foreign::StencilTableReal<float>> stencilsOf(const PolyMesh& mesh, int levels,
                                                                   bool controlVertices) {
  std::vector<int> sides, indices;
  for (const Loop& face : mesh.faces) {
    sides.push_back(static_cast<int>(face.size()));
    for (const std::size_t v : face) indices.push_back(static_cast<int>(v));
  }
  Foreign::TopologyDescriptor descriptor;
  descriptor.numVertices = static_cast<int>(mesh.points.size());
  descriptor.numFaces = static_cast<int>(sides.size());
  descriptor.numVertsPerFace = sides.data();
  descriptor.vertIndicesPerFace = indices.data();
  using Factory = Foreign::TopologyRefinerFactory<Foreign::TopologyDescriptor>;
  OpenSubdiv::Sdc::Options options;
  options.SetVtxBoundaryInterpolation(OpenSubdiv::Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
  const std::unique_ptr<Foreign::TopologyRefiner> refiner(
      Factory::Create(descriptor, {OpenSubdiv::Sdc::SCHEME_CATMARK, options}));
  refiner->RefineUniform(Foreign::TopologyRefiner::UniformOptions(levels));
  using Stencils = Foreign::StencilTableFactoryReal<float>;
  Stencils::Options how;
  how.generateOffsets = true;
  how.generateControlVerts = controlVertices;
  return std::unique_ptr<const Foreign::StencilTableReal<float>>(Stencils::Create(*refiner, how));
}

TEST(StencilExchange, OurEvaluatorsApplyOpenSubdivsTables) {
  for (const PolyMesh& mesh : {cube(), grid(4, 3)}) {
    for (const bool controlVertices : {false, true}) {
      const auto theirs = stencilsOf(mesh, 2, controlVertices);
      const auto table = Osd::fromOpenSubdiv(*theirs);
      ASSERT_TRUE(table) << table.error().message;
      EXPECT_EQ(static_cast<std::size_t>(table->sourceCount), mesh.points.size());
      const std::vector<float> control = pack<float>(mesh.points);
      expectNear(evaluatedHere(*table, table->targetCount, control), evaluatedByOpenSubdiv(*theirs, control));
    }
  }
}

TEST(StencilExchange, RefusesStencilsThatAreNoRows) {
  struct Unsound : Foreign::StencilTable {
    Unsound(const std::vector<int>& sizes, const std::vector<int>& sources)
        : StencilTable(3, {0, 2}, sizes, sources, {0.5F, 0.5F, 1.0F, 1.0F}, false, 0) {}
  };
  EXPECT_TRUE(Osd::fromOpenSubdiv(Unsound({2, 1}, {0, 1, 2})));
  EXPECT_EQ(Osd::fromOpenSubdiv(Unsound({2, 1}, {0, 1, 3})).error().element, 1);
  EXPECT_EQ(Osd::fromOpenSubdiv(Unsound({2, 0}, {0, 1})).error().element, 1);
  EXPECT_EQ(Osd::fromOpenSubdiv(Unsound({2, 1}, {0, -1, 2})).error().element, 0);
}

}  // namespace
}  // namespace honeycomb::Test
