// Limit positions and unit normals of faces and vertices, recorded behind the refinement.
#include <gmock/gmock.h>

#include <cmath>

#include "fixture.h"
#include "osd/vulkan/session.h"
#include "reference.h"
#include "runs.h"
#include "tests/support/random_tables.h"

namespace honeycomb::VulkanTests {
namespace {

using Test::randomLimits;
using Test::randomNumbers;
using Test::randomTable;

using testing::HasSubstr;

// Vertices 0..n-1 are in `vertices` or, the last `here` of them, in `verticesHere`.
Far::LimitTable randomLimitTable(std::int32_t points, std::int32_t here) {
  Far::LimitTable limits;
  limits.faces = randomLimits(points, {{4, 100}, {6, 50}, {70, 2}, {256, 1}, {257, 1}, {1000, 2}}, 3);
  limits.child = randomTable({.sourceCount = points, .circulants = {{6, 300}}, .projected = {300}, .looseRows = 30}, 4);
  limits.vertices = randomLimits(limits.child.targetCount, {{6, points - here}}, 5);
  limits.verticesHere = randomLimits(points, {{3, here}}, 6);
  for (std::int32_t& element : limits.verticesHere.elements) element += points - here;
  return limits;
}

struct Limits {
  std::vector<float> positions, normals;
};

Limits expected(const Far::LimitRows& rows, const std::vector<float>& points, const Osd::BufferDescriptor& desc,
                Limits into, const Osd::BufferDescriptor& positions, const Osd::BufferDescriptor& normals) {
  evaluateLimits(rows, points, desc, into.positions, positions, into.normals, normals);
  return into;
}

Limits emptyLimits(std::int64_t count, const Osd::BufferDescriptor& positions, const Osd::BufferDescriptor& normals) {
  return {std::vector<float>(static_cast<std::size_t>(positions.extent(count))),
          std::vector<float>(static_cast<std::size_t>(normals.extent(count)))};
}

class LimitsTest : public VulkanTest {
 protected:
  void SetUp() override {
    VulkanTest::SetUp();
    level = randomTable({.sourceCount = 300, .circulants = {{4, 100}, {6, 60}}});
    limits = randomLimitTable(level.targetCount, 40);
    limits.vertices.elementCount = limits.verticesHere.elementCount = level.targetCount;  // a result for every vertex
  }

  Result<Osd::VulkanSession> session(Osd::VulkanEvaluator& evaluator, const Osd::VulkanTableOptions& options) {
    auto table = evaluator.upload(std::vector<const Far::LevelTable*>{&level}, &limits, options);
    if (!table) return tl::unexpected(table.error());
    auto made = Osd::VulkanSession::create(evaluator, *table);
    if (made) std::ranges::copy(randomNumbers(options.control.extent(level.sourceCount)), made->control().begin());
    return made;
  }

  void check(const Osd::VulkanEvaluatorOptions& evaluatorOptions, const Osd::VulkanTableOptions& options);

  Far::LevelTable level;
  Far::LimitTable limits;
};

void LimitsTest::check(const Osd::VulkanEvaluatorOptions& evaluatorOptions, const Osd::VulkanTableOptions& options) {
  auto evaluator = makeEvaluator(evaluatorOptions);
  auto made = session(evaluator, options);
  ASSERT_TRUE(made) << made.error().message;
  const std::vector<float> control(made->control().begin(), made->control().end());
  ASSERT_TRUE(made->run());

  const std::vector<float> points = expectedPoints({level}, control, options.control, options.refined);
  EXPECT_TRUE(sameBits(points, made->refined()));
  const auto facePositions = *options.faceLimits.positions, faceNormals = *options.faceLimits.normals;
  const Limits faces =
      expected(limits.faces, points, options.refined,
               emptyLimits(limits.faces.elementCount, facePositions, faceNormals), facePositions, faceNormals);
  EXPECT_TRUE(sameBits(faces.positions, made->facePositions()));
  EXPECT_TRUE(sameBits(faces.normals, made->faceNormals()));

  const Osd::BufferDescriptor packed;
  const auto positions = *options.vertexLimits.positions, normals = *options.vertexLimits.normals;
  const std::vector<float> child = expectedPoints({limits.child}, points, options.refined, packed);
  Limits vertices =
      expected(limits.vertices, child, packed, emptyLimits(level.targetCount, positions, normals), positions, normals);
  vertices = expected(limits.verticesHere, points, options.refined, vertices, positions, normals);
  EXPECT_TRUE(sameBits(vertices.positions, made->vertexPositions()));
  EXPECT_TRUE(sameBits(vertices.normals, made->vertexNormals()));
}

constexpr Osd::BufferDescriptor kPacked{0, 3, 3};
constexpr Osd::BufferDescriptor kPadded{2, 3, 5};

TEST_F(LimitsTest, FacesAndVertices) {
  check({}, {.vertexLimits = {kPacked, kPacked}, .faceLimits = {kPacked, kPacked}});
}

TEST_F(LimitsTest, EveryBufferInALayoutOfItsOwn) {
  check({}, {.control = kPadded,
             .refined = {1, 3, 4},
             .vertexLimits = {kPadded, Osd::BufferDescriptor{0, 3, 4}},
             .faceLimits = {Osd::BufferDescriptor{3, 3, 6}, kPadded}});
}

TEST_F(LimitsTest, OverSeveralPages) {
  check({.maxStorageBufferRange = 16384}, {.vertexLimits = {kPadded, kPacked}, .faceLimits = {kPacked, kPadded}});
}

TEST_F(LimitsTest, NormalsAlone) {
  auto evaluator = makeEvaluator();
  auto all = session(evaluator, {.vertexLimits = {kPacked, kPacked}});
  auto normals = session(evaluator, {.vertexLimits = {.normals = kPacked}});
  ASSERT_TRUE(all && normals);
  ASSERT_TRUE(all->run() && normals->run());
  EXPECT_TRUE(normals->vertexPositions().empty());
  EXPECT_TRUE(normals->faceNormals().empty());
  EXPECT_TRUE(sameBits(all->vertexNormals(), normals->vertexNormals()));
}

TEST_F(LimitsTest, NormalsHaveLengthOne) {
  auto evaluator = makeEvaluator();
  auto made = session(evaluator, {.faceLimits = {.normals = kPacked}});
  ASSERT_TRUE(made && made->run());
  for (std::size_t i = 0; i < made->faceNormals().size(); i += 3) {
    const auto n = made->faceNormals().subspan(i, 3);
    EXPECT_NEAR(std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]), 1, 1e-6);
  }
}

// All points in one place, or so large that the length overflows.
TEST_F(LimitsTest, DegenerateNormalsAreZero) {
  auto evaluator = makeEvaluator();
  auto made = session(evaluator, {.vertexLimits = {.normals = kPacked}, .faceLimits = {.normals = kPacked}});
  ASSERT_TRUE(made) << made.error().message;
  for (const float value : {0.0F, 1e-25F, 1e30F}) {
    std::ranges::copy(randomNumbers(900), made->control().begin());
    for (float& number : made->control()) number *= value;
    ASSERT_TRUE(made->run());
    EXPECT_THAT(made->vertexNormals(), testing::Each(0.0F)) << "points times " << value;
    EXPECT_THAT(made->faceNormals(), testing::Each(0.0F)) << "points times " << value;
  }
}

TEST_F(LimitsTest, NeedALimitTable) {
  auto evaluator = makeEvaluator();
  const Osd::VulkanTableOptions options{.vertexLimits = {.normals = kPacked}};
  const auto none = evaluator.upload(std::vector<const Far::LevelTable*>{&level}, nullptr, options);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, ErrorCode::invalidOption);
  EXPECT_THAT(none.error().message, HasSubstr("RefineOptions::limits"));
  limits.faces.sourceCount += 1;
  const auto other = evaluator.upload(std::vector<const Far::LevelTable*>{&level}, &limits, options);
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().code, ErrorCode::invalidOption);
}

TEST_F(LimitsTest, AreOfPointsOfLengthThree) {
  auto evaluator = makeEvaluator();
  const auto refused =
      session(evaluator, {.control = {0, 4, 4}, .refined = {0, 4, 4}, .vertexLimits = {.normals = kPacked}});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::invalidOption);
}

}  // namespace
}  // namespace honeycomb::VulkanTests
