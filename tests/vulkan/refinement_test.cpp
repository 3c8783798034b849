// Real refinements: all levels, limits and normals, the same bits as the serial evaluator's.
#include "far/tables/refinement.h"

#include "far/tables/stencil_table.h"
#include "fixture.h"
#include "osd/cpu_evaluator.h"
#include "osd/vulkan/session.h"
#include "runs.h"
#include "tests/support/refined.h"
#include "tests/support/scheme_list.h"
#include "tests/support/shapes.h"

namespace honeycomb::VulkanTests {
namespace {

namespace Meshes = honeycomb::Test;  // inside of tests, Test is GoogleTest's class
using Meshes::refined;
using Meshes::schemeCase;
using Osd::BufferDescriptor;
using Osd::PointsOut;

constexpr BufferDescriptor kPaddedByOne{2, 3, 4};

struct LimitArrays {
  std::vector<float> positions, normals;
  explicit LimitArrays(std::int64_t count)
      : positions(static_cast<std::size_t>(BufferDescriptor{}.extent(count))), normals(positions) {}
};

void throwError(const Result<void>& result) {
  if (!result) throw std::runtime_error(result.error().message);
}

class RefinementTest : public VulkanTest {
 protected:
  void compare(const Far::Refinement& refinement, const std::vector<float>& control,
               const Osd::VulkanEvaluatorOptions& options = {});
  void compareLimits(const Far::Refinement& refinement, const std::vector<float>& points,
                     const Osd::VulkanSession& session);
  Osd::SerialEvaluator serial;
};

void RefinementTest::compare(const Far::Refinement& refinement, const std::vector<float>& control,
                             const Osd::VulkanEvaluatorOptions& options) {
  auto evaluator = makeEvaluator(options);
  Osd::VulkanTableOptions layout{.refined = kPaddedByOne};
  if (refinement.limits().faces.elementCount > 0) {
    layout.vertexLimits = layout.faceLimits = {BufferDescriptor{}, BufferDescriptor{}};
  }
  auto session = Osd::VulkanSession::create(evaluator, refinement, layout);
  ASSERT_TRUE(session) << session.error().message;
  std::ranges::copy(control, session->control().begin());
  ASSERT_TRUE(session->run());

  std::vector<float> points(session->refined().size());
  throwError(serial.evaluate<float>(refinement, refinement.levelCount(), {control, {}}, {points, kPaddedByOne}));
  ASSERT_TRUE(sameBits(points, session->refined()));
  if (!layout.faceLimits.empty()) compareLimits(refinement, points, *session);
}

void RefinementTest::compareLimits(const Far::Refinement& refinement, const std::vector<float>& points,
                                   const Osd::VulkanSession& session) {
  const Far::Topology& last = refinement.last().topology;
  LimitArrays faces(last.faceCount()), vertices(last.vertexCount());
  const Osd::Points<float> source{points, kPaddedByOne};
  throwError(serial.faceLimits<float>(refinement.limits(), source, {faces.positions, {}}, {faces.normals, {}}));
  throwError(serial.vertexLimits<float>(refinement.limits(), source, {vertices.positions, {}}, {vertices.normals, {}}));
  EXPECT_TRUE(sameBits(faces.positions, session.facePositions()));
  EXPECT_TRUE(sameBits(faces.normals, session.faceNormals()));
  EXPECT_TRUE(sameBits(vertices.positions, session.vertexPositions()));
  EXPECT_TRUE(sameBits(vertices.normals, session.vertexNormals()));
}

TEST_F(RefinementTest, OfRandomMeshesClosedAndOpen) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Meshes::RandomMesh random = Meshes::randomMesh(seed);
    SCOPED_TRACE(testing::Message() << "random mesh " << seed);
    compare(refined(random, schemeCase(0.6).scheme, 3, true), Meshes::pack<float>(random.mesh.points));
  }
}

TEST_F(RefinementTest, OfEveryBoundaryRule) {
  for (const auto boundary :
       {Meshes::ReferenceBoundary::brick, Meshes::ReferenceBoundary::eq16, Meshes::ReferenceBoundary::drop}) {
    const Meshes::RandomMesh random = Meshes::randomMesh(11, Meshes::Border::open);
    const auto tags = boundary == Meshes::ReferenceBoundary::brick ? random.cornerTags : std::vector<std::size_t>{};
    const auto scheme = schemeCase(Meshes::NamedTension::paper, boundary).scheme;
    compare(refined(random.mesh, scheme, 2, tags, true), Meshes::pack<float>(random.mesh.points));
  }
}

TEST_F(RefinementTest, UnderEveryScheme) {
  for (const Meshes::PolyMesh& mesh : {Meshes::torus(12, 10), Meshes::grid(10, 9)}) {
    for (const Meshes::ListedScheme& scheme : Meshes::listedSchemes()) {
      SCOPED_TRACE(scheme.name);
      compare(Meshes::refinedBy(scheme, Meshes::toTopology(mesh), 2, true), Meshes::pack<float>(mesh.points));
    }
  }
}

TEST_F(RefinementTest, OfLargeFaces) {
  const Meshes::PolyMesh mesh = Meshes::prism(5000);
  compare(refined(mesh, schemeCase(0.6).scheme, 2, {}, true), Meshes::pack<float>(mesh.points));
}

TEST_F(RefinementTest, OfLargeFacesWithCentralControlVertices) {
  const Meshes::PolyMesh mesh = Meshes::prism(3000);
  for (const Meshes::ListedScheme& scheme : Meshes::listedSchemes()) {
    if (!scheme.name.starts_with("zhang-wang")) continue;
    SCOPED_TRACE(scheme.name);
    const Far::Refinement refinement = Meshes::refinedBy(scheme, Meshes::toTopology(mesh), 2, true);
    compare(refinement, Meshes::pack<float>(mesh.points));
    compare(refinement, Meshes::pack<float>(mesh.points), {.maxStorageBufferRange = 1 << 19});
  }
}

TEST_F(RefinementTest, OverSeveralPages) {
  const Meshes::PolyMesh mesh = Meshes::torus(30, 20);
  compare(refined(mesh, schemeCase(0.6).scheme, 3, {}, true), Meshes::pack<float>(mesh.points),
          {.maxStorageBufferRange = 1 << 17});
}

TEST_F(RefinementTest, OfStencilTables) {
  const Meshes::PolyMesh mesh = Meshes::grid(6, 5);
  const Far::Refinement refinement = refined(mesh, schemeCase(0.6).scheme, 2, {}, true);
  const std::vector<float> control = Meshes::pack<float>(mesh.points);
  const auto table = Far::StencilTable::build(refinement, {.kind = Far::StencilKind::vertexLimits});
  ASSERT_TRUE(table) << table.error().message;
  auto evaluator = makeEvaluator();
  for (const auto which : {Far::StencilWeights::position, Far::StencilWeights::tangent2}) {
    auto session = Osd::VulkanSession::create(evaluator, *evaluator.upload(*table, which));
    ASSERT_TRUE(session) << session.error().message;
    std::vector<float> expected(session->refined().size()), out(expected);
    ASSERT_TRUE(session->refine(control, out));
    throwError(serial.evaluate<float>(*table, {control, {}}, {expected, {}}, which));
    EXPECT_TRUE(sameBits(expected, out));
  }
}

TEST_F(RefinementTest, ThroughStaging) {
  const Meshes::PolyMesh mesh = Meshes::torus(30, 20);
  compare(refined(mesh, schemeCase(0.6).scheme, 2, {}, true), Meshes::pack<float>(mesh.points),
          {.stageEverything = true});
}

}  // namespace
}  // namespace honeycomb::VulkanTests
