#include "far/tables/stencil_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "far/base/parallel.h"
#include "far/schemes/zhang_wang.h"
#include "far/tables/level_rows.h"
#include "osd/cpu_evaluator.h"
#include "tests/support/random_tables.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"
#include "tests/support/table_rows.h"

namespace honeycomb::Test {
namespace {

using Far::StencilChoice;
using Far::StencilKind;
using Far::StencilOptions;
using Far::StencilTable;
using Far::StencilWeights;

StencilTable built(const Far::Refinement& refinement, const StencilOptions& options) {
  auto table = StencilTable::build(refinement, options);
  if (!table) throw std::runtime_error(table.error().message);
  return std::move(*table);
}

std::vector<Vec3> evaluated(const StencilTable& table, const std::vector<Vec3>& control,
                            StencilWeights which = StencilWeights::position) {
  const std::vector<double> in = pack<double>(control);
  std::vector<double> out(3 * static_cast<std::size_t>(table.rowCount()));
  Osd::SerialEvaluator evaluator;
  const auto done = evaluator.evaluate(table, Osd::Points<double>{in, {}}, Osd::PointsOut<double>{out, {}}, which);
  if (!done) throw std::runtime_error(done.error().message);
  return unpack(out);
}

double largestDistance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double largest = a.size() == b.size() ? 0 : HUGE_VAL;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) largest = std::max(largest, distance(a[i], b[i]));
  return largest;
}

double rowTotal(const StencilTable& table, std::int32_t row, StencilWeights which) {
  const auto weights = table.weightsAs<double>(which);
  return std::accumulate(weights.begin() + at(table.offsets, row), weights.begin() + at(table.offsets, row + 1), 0.0);
}

/// Entries strictly ascending within the control points, weights adding up to 1, those of tangents to 0.
void expectSound(const StencilTable& table) {
  ASSERT_EQ(table.offsets.size(), table.outputs.size() + 1);
  ASSERT_EQ(static_cast<std::size_t>(table.offsets.back()), table.indices.size());
  for (std::int32_t r = 0; r < table.rowCount(); ++r) {
    const auto begin = table.indices.begin() + at(table.offsets, r),
               end = table.indices.begin() + at(table.offsets, r + 1);
    ASSERT_LT(begin, end) << "row " << r;
    ASSERT_GE(*begin, 0);
    ASSERT_LT(*(end - 1), table.sourceCount);
    ASSERT_EQ(std::adjacent_find(begin, end, std::greater_equal<>()), end) << "row " << r;
    ASSERT_NEAR(rowTotal(table, r, StencilWeights::position), 1, 1e-12) << "row " << r;
    if (!table.hasTangents()) continue;
    ASSERT_NEAR(rowTotal(table, r, StencilWeights::tangent1), 0, 1e-12) << "row " << r;
    ASSERT_NEAR(rowTotal(table, r, StencilWeights::tangent2), 0, 1e-12) << "row " << r;
  }
}

/// Row `r` of `part` is row `of` of `whole`, bit for bit.
testing::AssertionResult sameRow(const StencilTable& part, std::int32_t r, const StencilTable& whole, std::int32_t of) {
  const auto slice = [](const auto& values, const StencilTable& table, std::int32_t row) {
    using Values = std::decay_t<decltype(values)>;
    if (values.empty()) return Values{};
    return Values(values.begin() + at(table.offsets, row), values.begin() + at(table.offsets, row + 1));
  };
  const bool same = slice(part.indices, part, r) == slice(whole.indices, whole, of) &&
                    slice(part.weights, part, r) == slice(whole.weights, whole, of) &&
                    slice(part.weightsSingle, part, r) == slice(whole.weightsSingle, whole, of) &&
                    slice(part.tangent1, part, r) == slice(whole.tangent1, whole, of) &&
                    slice(part.tangent2Single, part, r) == slice(whole.tangent2Single, whole, of);
  return same ? testing::AssertionSuccess() : testing::AssertionFailure() << "row " << r << " is not row " << of;
}

bool survives(const PolyMesh& mesh, const SchemeCase& scheme, std::int32_t levels) {
  for (std::int32_t k = 1; k <= levels; ++k) {
    if (referenceLevel(mesh, {}, scheme.reference, k).mesh.faces.empty()) return false;
  }
  return true;
}

/// Random meshes under every boundary rule; `drop` eats into the boundary, and is left out where it leaves nothing.
template <class Body>
void forRandomRefinements(std::int32_t levels, bool limits, const Body& body) {
  for (const auto boundary : {ReferenceBoundary::brick, ReferenceBoundary::eq16, ReferenceBoundary::drop}) {
    const SchemeCase scheme = schemeCase(NamedTension::paper, boundary);
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      const RandomMesh random = randomMesh(seed);
      const bool drop = boundary == ReferenceBoundary::drop;
      if (drop && !survives(random.mesh, scheme, limits ? 2 : 1)) continue;
      SCOPED_TRACE(scheme.name + ", seed " + std::to_string(seed));
      ASSERT_NO_FATAL_FAILURE(body(random.mesh, refined(random, scheme.scheme, drop ? 1 : levels, limits)));
    }
  }
}

TEST(StencilTable, GivesThePointsOfEveryLevel) {
  forRandomRefinements(3, false, [](const PolyMesh& mesh, const Far::Refinement& refinement) {
    for (std::int32_t k = 1; k <= refinement.levelCount(); ++k) {
      const StencilTable table = built(refinement, {.level = k});
      ASSERT_NO_FATAL_FAILURE(expectSound(table));
      ASSERT_LT(largestDistance(evaluated(table, mesh.points), levelPoints<double>(refinement, k, mesh.points)), 1e-12);
    }
  });
}

TEST(StencilTable, GivesTheLimitsOfVerticesAndFaces) {
  forRandomRefinements(2, true, [](const PolyMesh& mesh, const Far::Refinement& refinement) {
    const auto points = levelPoints<double>(refinement, refinement.levelCount(), mesh.points);
    for (const StencilKind kind : {StencilKind::vertexLimits, StencilKind::faceLimits}) {
      const StencilTable table = built(refinement, {.kind = kind});
      const Limits expected = kind == StencilKind::faceLimits ? faceLimits<double>(refinement, points)
                                                              : vertexLimits<double>(refinement, points);
      ASSERT_NO_FATAL_FAILURE(expectSound(table));
      ASSERT_LT(largestDistance(evaluated(table, mesh.points), expected.positions), 1e-12);
      const auto t1 = evaluated(table, mesh.points, StencilWeights::tangent1);
      const auto t2 = evaluated(table, mesh.points, StencilWeights::tangent2);
      for (std::size_t i = 0; i < t1.size(); ++i) {
        const Vec3 normal = cross(t1[i], t2[i]);
        // What rounding leaves of the direction of a cross product of tangents of length 1.
        if (length(normal) < 1e-6) continue;
        ASSERT_LT(distance(unit(normal), expected.normals[i]), 1e-9) << "element " << i;
      }
    }
  });
}

TEST(StencilTable, HasTangentsByCosinesAndSinesWhateverTheNumberOfSides) {
  const PolyMesh mesh = torus(6, 5);
  const Far::Refinement refinement = refined(mesh, schemeCase(NamedTension::paper).scheme, 2, {}, true);
  const auto points = levelPoints<double>(refinement, 2, mesh.points);
  const StencilTable table = built(refinement, {.kind = StencilKind::faceLimits});
  const auto t1 = evaluated(table, mesh.points, StencilWeights::tangent1);
  const auto t2 = evaluated(table, mesh.points, StencilWeights::tangent2);
  const Far::Topology& topology = refinement.last().topology;
  for (std::int32_t f = 0; f < topology.faceCount(); ++f) {
    const std::int32_t n = topology.sides(f);
    Vec3 cosines{0, 0, 0};
    Vec3 sines{0, 0, 0};
    for (std::int32_t j = 0; j < n; ++j) {
      const Vec3& p = at(points, topology.vert(at(topology.faceOffsets(), f) + j));
      cosines = cosines + std::cos(2 * std::numbers::pi * j / n) * p;
      sines = sines + std::sin(2 * std::numbers::pi * j / n) * p;
    }
    ASSERT_LT(distance(at(t1, f), cosines), 1e-12) << n << " sides";
    ASSERT_LT(distance(at(t2, f), sines), 1e-12) << n << " sides";
  }
}

TEST(StencilTable, ChoicesAreRowsOfTheWhole) {
  forRandomRefinements(2, true, [](const PolyMesh&, const Far::Refinement& refinement) {
    const Far::Topology& level = refinement.last().topology;
    const std::vector<std::int32_t> vertices{level.vertexCount() - 1, 0, level.vertexCount() / 2, 0};
    for (const StencilKind kind : {StencilKind::points, StencilKind::vertexLimits}) {
      const StencilTable whole = built(refinement, {.kind = kind});
      const StencilTable part = built(refinement, {.kind = kind, .choice = StencilChoice::vertices(vertices)});
      ASSERT_EQ(part.outputs, vertices);
      for (std::int32_t r = 0; r < part.rowCount(); ++r) ASSERT_TRUE(sameRow(part, r, whole, at(vertices, r)));
    }
    const std::vector<std::int32_t> faces{level.faceCount() - 1, 0};
    const StencilTable whole = built(refinement, {.kind = StencilKind::faceLimits});
    const StencilTable part =
        built(refinement, {.kind = StencilKind::faceLimits, .choice = StencilChoice::faces(faces)});
    ASSERT_EQ(part.outputs, faces);
    for (std::int32_t r = 0; r < part.rowCount(); ++r) ASSERT_TRUE(sameRow(part, r, whole, at(faces, r)));
  });
}

TEST(StencilTable, ChosenFacesBringTheirVerticesOnce) {
  const Far::Refinement refinement = refined(torus(5, 4), schemeCase(NamedTension::paper).scheme, 2);
  const Far::Topology& level = refinement.level(1).topology;
  const StencilTable part = built(refinement, {.level = 1, .choice = StencilChoice::faces({7, 30, 7, 2})});
  std::vector<std::int32_t> expected;
  for (const std::int32_t f : {7, 30, 2}) {
    for (std::int32_t i = 0; i < level.sides(f); ++i) {
      const std::int32_t v = level.vert(at(level.faceOffsets(), f) + i);
      if (std::ranges::find(expected, v) == expected.end()) expected.push_back(v);
    }
  }
  EXPECT_EQ(part.outputs, expected);
  EXPECT_LT(expected.size(), std::size_t{4 + 8 + 4 + 1});
  const StencilTable whole = built(refinement, {.level = 1});
  for (std::int32_t r = 0; r < part.rowCount(); ++r) EXPECT_TRUE(sameRow(part, r, whole, at(expected, r)));
}

TEST(StencilTable, LevelRowsGiveEveryBatchKind) {
  const Far::LevelTable table = randomTable({.sourceCount = 300,
                                             .circulants = {{3, 20}, {6, 30}, {7, 10}},
                                             .projected = {65, 300},
                                             .halfProjected = {80},
                                             .dense = {{1, 5}, {4, 30}, {16, 7}},
                                             .looseRows = 40});
  const auto expected = expandRows(table);
  const Far::LevelRows rows(table);
  ASSERT_EQ(static_cast<std::size_t>(rows.rowCount()), expected.size());
  for (std::int32_t r = 0; r < rows.rowCount(); ++r) {
    StencilRow row;
    std::int32_t entries = 0;
    rows.visit(r, [&](std::int32_t point, double w) {
      row[point] += w;
      ++entries;
    });
    EXPECT_EQ(entries, rows.entryCount(r));
    ASSERT_EQ(row.size(), at(expected, r).size());
    for (const auto& [point, w] : at(expected, r)) ASSERT_NEAR(row.at(point), w, 1e-13) << "row " << r;
  }
}

/// A refinement of random tables, with more points a level than vertices: as with central control vertices.
Far::Refinement randomRefinement() {
  const Far::Topology topology = toTopology(cube());
  std::vector<Far::Level> levels{{topology, {}}};
  levels.push_back({topology, randomTable({.sourceCount = 90,
                                           .circulants = {{4, 9}, {5, 4}},
                                           .projected = {70, 66},
                                           .dense = {{2, 17}, {7, 12}},
                                           .looseRows = 20},
                                          1)});
  levels.push_back({topology, randomTable({.sourceCount = levels[1].table.targetCount,
                                           .circulants = {{6, 8}},
                                           .projected = {100, 200},
                                           .halfProjected = {66},
                                           .dense = {{4, 30}},
                                           .looseRows = 30},
                                          2)});
  return {std::move(levels), {}};
}

TEST(StencilTable, ComposesEveryBatchKind) {
  const Far::Refinement refinement = randomRefinement();
  const StencilTable table = built(refinement, {});
  const auto expected = composeRows(expandRows(refinement.level(2).table), expandRows(refinement.level(1).table));
  ASSERT_EQ(static_cast<std::size_t>(table.rowCount()), expected.size());
  for (std::int32_t r = 0; r < table.rowCount(); ++r) {
    const StencilRow& row = at(expected, r);
    ASSERT_EQ(static_cast<std::size_t>(at(table.offsets, r + 1) - at(table.offsets, r)), row.size());
    std::int32_t b = at(table.offsets, r);
    for (const auto& [point, w] : row) {
      ASSERT_EQ(at(table.indices, b), point);
      ASSERT_NEAR(at(table.weights, b), w, 1e-11) << "row " << r;
      ASSERT_EQ(at(table.weightsSingle, b), static_cast<float>(at(table.weights, b)));
      ++b;
    }
  }
}

/// x y z of the level, by the chained tables, for every point of it.
std::vector<Vec3> chained(const Far::Refinement& refinement, const std::vector<Vec3>& control) {
  const std::vector<double> in = pack<double>(control);
  std::vector<double> out(3 * static_cast<std::size_t>(refinement.last().table.targetCount));
  Osd::SerialEvaluator evaluator;
  const auto done = evaluator.evaluate(refinement, refinement.levelCount(), Osd::Points<double>{in, {}},
                                       Osd::PointsOut<double>{out, {}});
  if (!done) throw std::runtime_error(done.error().message);
  return unpack(out);
}

TEST(StencilTable, TakesCentralControlVerticesAlong) {
  Random random(5);
  for (const PolyMesh& mesh : {prism(5), torus(5, 4), grid(4, 3)}) {
    const Far::Topology topology = toTopology(mesh);
    const auto schemes = Far::zhangWang(topology, 3);
    ASSERT_TRUE(schemes) << schemes.error().message;
    const auto refinement = Far::refine(topology, *schemes, {.centralPoints = true, .limits = true});
    ASSERT_TRUE(refinement) << refinement.error().message;
    std::vector<Vec3> control = mesh.points;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      control.push_back({random.symmetric(), random.symmetric(), random.symmetric()});
    }
    const StencilTable table = built(*refinement, {});
    ASSERT_NO_FATAL_FAILURE(expectSound(table));
    EXPECT_EQ(table.rowCount(), refinement->last().topology.vertexCount() + refinement->last().topology.faceCount());
    const std::vector<Vec3> points = chained(*refinement, control);
    EXPECT_LT(largestDistance(evaluated(table, control), points), 1e-12);
    const StencilTable limits = built(*refinement, {.kind = StencilKind::vertexLimits});
    EXPECT_LT(largestDistance(evaluated(limits, control), vertexLimits<double>(*refinement, points).positions), 1e-12);
  }
}

TEST(StencilTable, ComposesRowsThatReadTheSumsOfLargeFaces) {
  const PolyMesh mesh = prism(90);
  const Far::Topology topology = toTopology(mesh);
  const auto schemes = Far::zhangWang(topology, 3);
  ASSERT_TRUE(schemes) << schemes.error().message;
  const auto refinement = Far::refine(topology, *schemes, {});
  ASSERT_TRUE(refinement) << refinement.error().message;
  ASSERT_GT(refinement->level(1).table.summed.rowCount(), 0);
  const StencilTable table = built(*refinement, {});
  ASSERT_NO_FATAL_FAILURE(expectSound(table));
  EXPECT_LT(largestDistance(evaluated(table, mesh.points), chained(*refinement, mesh.points)), 1e-12);
}

TEST(StencilTable, IsTheSameOnAnyNumberOfThreads) {
  const Far::Refinement refinement = refined(grid(40, 30), schemeCase(NamedTension::paper).scheme, 2, {}, true);
  for (const StencilKind kind : {StencilKind::points, StencilKind::vertexLimits}) {
    const StencilTable all = built(refinement, {.kind = kind});
    const Parallel::ThreadLimit limit(1);
    const StencilTable one = built(refinement, {.kind = kind});
    EXPECT_EQ(one.offsets, all.offsets);
    EXPECT_EQ(one.indices, all.indices);
    EXPECT_EQ(one.weights, all.weights);
    EXPECT_EQ(one.tangent2, all.tangent2);
  }
}

TEST(StencilTable, TakesOnePointOfAHugeFaceInLinearTime) {
  const PolyMesh mesh = prism(50000);
  const Far::Refinement refinement = refined(mesh, schemeCase(NamedTension::paper).scheme, 2);
  const auto points = levelPoints<double>(refinement, 2, mesh.points);
  const auto last = static_cast<std::int32_t>(points.size()) - 1;
  const StencilTable table = built(refinement, {.choice = StencilChoice::vertices({0, last / 2, last})});
  ASSERT_NO_FATAL_FAILURE(expectSound(table));
  EXPECT_LT(largestDistance(evaluated(table, mesh.points),
                            {points[0], points[points.size() - 1 - points.size() / 2], points.back()}),
            1e-12);
}

TEST(StencilTable, RefusesMoreEntriesThanCanBeNumbered) {
  // Two faces of 50,000 corners, each a point of all of them.
  const Far::Refinement refinement = refined(prism(50000), schemeCase(NamedTension::paper).scheme, 1);
  const auto refused = StencilTable::build(refinement);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::tooLarge);
  EXPECT_THAT(refused.error().message, testing::HasSubstr("level 1 have more than 2^31 - 1 entries"));
}

TEST(StencilTable, KeepsToTheMemoryAllowed) {
  const Far::Refinement refinement = refined(torus(5, 4), schemeCase(NamedTension::paper).scheme, 2, {}, true);
  for (const StencilKind kind : {StencilKind::points, StencilKind::faceLimits}) {
    const std::int64_t bytes = built(refinement, {.kind = kind}).byteCount();
    EXPECT_TRUE(StencilTable::build(refinement, {.kind = kind, .memoryLimit = bytes}));
    const auto refused = StencilTable::build(refinement, {.kind = kind, .memoryLimit = bytes - 40});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::tooLarge);
  }
}

void expectRefused(const Far::Refinement& refinement, const StencilOptions& options, const std::string& message,
                   std::int64_t element) {
  const auto refused = StencilTable::build(refinement, options);
  ASSERT_FALSE(refused) << message;
  EXPECT_EQ(refused.error().code, ErrorCode::invalidOption);
  EXPECT_EQ(refused.error().message, message);
  EXPECT_EQ(refused.error().element, element);
}

TEST(StencilTable, RefusesWhatIsNotThere) {
  const Far::Refinement refinement = refined(cube(), schemeCase(NamedTension::paper).scheme, 2, {}, true);
  const StencilKind ofFaces = StencilKind::faceLimits;
  expectRefused(refinement, {.level = 3}, "level 3 is out of range; use 1 to 2", 3);
  expectRefused(refinement, {.level = -1}, "level -1 is out of range; use 1 to 2", -1);
  expectRefused(refinement, {.choice = StencilChoice::vertices({3, 72})},
                "vertex 72 is not in level 2; choose from vertices 0 to 71", 72);
  expectRefused(refinement, {.level = 1, .choice = StencilChoice::vertices({-1})},
                "vertex -1 is not in level 1; choose from vertices 0 to 23", -1);
  expectRefused(refinement, {.level = 1, .choice = StencilChoice::faces({14})},
                "face 14 is not in level 1; choose from faces 0 to 13", 14);
  expectRefused(refinement, {.kind = ofFaces, .choice = StencilChoice::faces({38})},
                "face 38 is not in level 2; choose from faces 0 to 37", 38);
  expectRefused(refinement, {.kind = ofFaces, .choice = StencilChoice::vertices({0})},
                "face limits can't be chosen by vertices; choose faces", -1);
  const Far::Refinement bare = refined(cube(), schemeCase(NamedTension::paper).scheme, 1);
  expectRefused(bare, {.kind = StencilKind::vertexLimits},
                "the refinement was built without limits; ask for them with RefineOptions", -1);
  expectRefused(refined(cube(), schemeCase(NamedTension::paper).scheme, 0), {},
                "stencils need a level; refine by at least one", -1);
}

TEST(StencilTable, OfNothingIsEmpty) {
  const Far::Refinement refinement = refined(cube(), schemeCase(NamedTension::paper).scheme, 1);
  const StencilTable table = built(refinement, {.choice = StencilChoice::faces({})});
  EXPECT_EQ(table.rowCount(), 0);
  EXPECT_EQ(table.offsets, std::vector<std::int32_t>{0});
  EXPECT_TRUE(evaluated(table, cube().points).empty());
}

}  // namespace
}  // namespace honeycomb::Test
