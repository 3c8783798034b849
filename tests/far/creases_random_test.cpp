#include <gtest/gtest.h>

#include "far/schemes/akleman.h"
#include "far/schemes/half_box.h"
#include "far/schemes/zhang_wang.h"
#include "osd/cpu_evaluator.h"
#include "tests/support/creased.h"
#include "tests/support/manifold_check.h"
#include "tests/support/refined.h"
#include "tests/support/table_rows.h"

namespace honeycomb::Test {
namespace {

constexpr std::int32_t kLevels = 3;

struct CreasedCase {
  RandomMesh random;
  Far::Topology control;
  std::vector<Far::Scheme> chain;
};

/// A creased random mesh and a chain of one of the schemes on the zip split.
CreasedCase randomCase(std::uint64_t seed) {
  CreasedCase c{randomMesh(seed), {}, {}};
  Random choice(seed + 1000);
  c.control = randomlyCreased(c.random, choice, {0.5, 1, 1.25, 2, 2.5, 3, Far::kSharp});
  if (choice.chance(0.5)) {
    c.chain.assign(kLevels, *Far::akleman({}));
  } else {
    Far::ZhangWangOptions options;
    options.boundary = Far::BoundaryRule::brick;
    options.unchecked = true;
    c.chain = *Far::zhangWang(c.control, kLevels, options);
  }
  return c;
}

template <class Check>
void forRandomCases(std::uint64_t seeds, const Check& check) {
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const CreasedCase c = randomCase(seed);
    const Result<Far::Refinement> refinement = Far::refine(c.control, c.chain, {});
    ASSERT_TRUE(refinement.has_value()) << refinement.error().message;
    check(*refinement, c);
    if (testing::Test::HasFatalFailure()) return;
  }
}

/// What the loops don't say: twins, outgoing half-edges, the places of cuts.
void expectSound(const Far::Topology& topology) {
  for (std::int32_t h = 0; h < topology.halfEdgeCount(); ++h) {
    const std::int32_t twin = topology.twin(h);
    if (twin < 0) continue;
    ASSERT_EQ(topology.twin(twin), h);
    ASSERT_EQ(topology.vert(twin), topology.dest(h));
  }
  for (std::int32_t v = 0; v < topology.vertexCount(); ++v) {
    ASSERT_EQ(topology.vert(topology.outgoing(v)), v);
    ASSERT_EQ(topology.twin(topology.outgoing(v)) < 0, topology.onBoundary(v));
  }
  for (const Far::FaceRun& run : topology.runs()) {
    for (std::int32_t f = run.firstFace; f < run.firstFace + run.faceCount; ++f) {
      const std::int32_t first = at(topology.faceOffsets(), f);
      ASSERT_TRUE(run.kind == Far::FaceKind::full || topology.twin(first) < 0);
      if (run.kind == Far::FaceKind::corner) {
        ASSERT_EQ(topology.vertexTag(topology.dest(first)), Far::VertexTag::fixedCorner);
      }
    }
  }
}

TEST(RandomCreases, EveryLevelIsASoundManifold) {
  forRandomCases(50, [](const Far::Refinement& refinement, const CreasedCase&) {
    for (std::int32_t k = 1; k <= kLevels; ++k) {
      const Far::Topology& topology = refinement.level(k).topology;
      ASSERT_NO_FATAL_FAILURE(expectSound(topology)) << "level " << k;
      std::string why;
      const std::vector<Vec3> none(static_cast<std::size_t>(topology.vertexCount()));
      ASSERT_TRUE(isManifold(toMesh(topology, none).faces, &why)) << "level " << k << ": " << why;
    }
  });
}

TEST(RandomCreases, RowsAddUpToOne) {
  forRandomCases(40, [](const Far::Refinement& refinement, const CreasedCase&) {
    for (std::int32_t k = 1; k <= kLevels; ++k) {
      for (const StencilRow& row : expandRows(refinement.level(k).table)) {
        double sum = 0;
        for (const auto& [point, weight] : row) {
          sum += weight;
          ASSERT_GE(weight, -1e-12) << "level " << k;
        }
        ASSERT_NEAR(sum, 1, 1e-11) << "level " << k;
      }
    }
  });
}

TEST(RandomCreases, SidesKeepTheSamePoints) {
  forRandomCases(40, [](const Far::Refinement& refinement, const CreasedCase& c) {
    for (std::int32_t k = 1; k <= kLevels; ++k) {
      const auto points = levelPoints<float>(refinement, k, c.random.mesh.points);
      ASSERT_EQ(sidesDiffer(refinement.level(k), points), "") << "level " << k;
    }
  });
}

TEST(RandomCreases, OnceAllAreClosedTheCountsAreThoseWithoutCreases) {
  int closed = 0;
  forRandomCases(40, [&closed](const Far::Refinement& refinement, const CreasedCase& c) {
    const Far::Topology smooth = toTopology(c.random.mesh, c.random.cornerTags);
    const auto without = Far::predict(smooth, c.chain);
    const auto with = Far::predict(c.control, c.chain);
    for (std::int32_t k = 0; k <= kLevels; ++k) {
      const Far::Topology& topology = refinement.level(k).topology;
      ASSERT_GE(at(with, k).halfEdges, topology.halfEdgeCount()) << "level " << k;
      ASSERT_TRUE(!at(with, k).exact || at(with, k).halfEdges == topology.halfEdgeCount()) << "level " << k;
      if (k == 0 || !topology.creases().empty()) continue;
      ++closed;
      ASSERT_EQ(topology.vertexCount(), at(without, k).vertices) << "level " << k;
      ASSERT_EQ(topology.halfEdgeCount(), at(without, k).halfEdges) << "level " << k;
      ASSERT_EQ(topology.faceCount(), at(without, k).faces) << "level " << k;
      ASSERT_EQ(topology.boundaryEdgeCount(), at(without, k).boundaryEdges) << "level " << k;
    }
  });
  EXPECT_GT(closed, 10);
}

TEST(RandomCreases, EvaluatorsGiveTheSameBits) {
  forRandomCases(40, [](const Far::Refinement& refinement, const CreasedCase& c) {
    const std::vector<float> in = pack<float>(c.random.mesh.points);
    std::vector<float> serial(3 * static_cast<std::size_t>(refinement.last().pointCount()));
    std::vector<float> threads(serial.size());
    Osd::SerialEvaluator one;
    Osd::TbbEvaluator all;
    const Osd::Points<float> points{in, {0, 3, 3}};
    ASSERT_TRUE(one.evaluate(refinement, kLevels, points, Osd::PointsOut<float>{serial, {0, 3, 3}}));
    ASSERT_TRUE(all.evaluate(refinement, kLevels, points, Osd::PointsOut<float>{threads, {0, 3, 3}}));
    ASSERT_EQ(serial, threads);
  });
}

TEST(RandomCreases, LimitsOfCutLevelsAreThoseOfABoundary) {
  forRandomCases(40, [](const Far::Refinement&, const CreasedCase& c) {
    const std::vector<Far::Scheme> chain(c.chain.begin(), c.chain.begin() + 2);
    const Result<Far::Refinement> refinement = Far::refine(c.control, chain, {.limits = true, .memoryLimit = 0});
    ASSERT_TRUE(refinement.has_value()) << refinement.error().message;
    const auto points = levelPoints<double>(*refinement, 2, c.random.mesh.points);
    const Limits limits = vertexLimits<double>(*refinement, points);
    const Far::Topology& topology = refinement->last().topology;
    for (const Far::CreaseEdge& crease : topology.creases()) {
      const Vec3& here = at(limits.positions, topology.vert(crease.halfEdge));
      const Vec3& there = at(limits.positions, topology.dest(crease.mate));
      ASSERT_LT(distance(here, there), 1e-12);
    }
  });
}

TEST(RandomCreases, OfHalfBoxSplinesKeepTheirSidesTogether) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const RandomMesh random = randomMesh(seed);
    Random choice(seed + 2000);
    const Far::Topology control = randomlyCreased(random, choice, {Far::kSharp});
    Far::HalfBoxOptions options;
    options.conversion = Far::HalfBoxConversion::akleman;
    options.boundary = Far::HalfBoxBoundary::clamped;
    if (control.creases().empty()) continue;
    const Far::Refinement refinement = refinedBy(control, *Far::halfBox(control, 1, options));
    for (std::int32_t k = 1; k <= refinement.levelCount(); ++k) {
      const Far::Level& level = refinement.level(k);
      ASSERT_EQ(sidesDiffer(level, levelPoints<float>(refinement, k, random.mesh.points)), "") << "level " << k;
      for (const StencilRow& row : expandRows(level.table)) {
        double sum = 0;
        for (const auto& [point, weight] : row) sum += weight;
        ASSERT_NEAR(sum, 1, 1e-11) << "level " << k;
      }
      std::string why;
      const std::vector<Vec3> none(static_cast<std::size_t>(level.topology.vertexCount()));
      ASSERT_TRUE(isManifold(toMesh(level.topology, none).faces, &why)) << "level " << k << ": " << why;
    }
  }
}

}  // namespace
}  // namespace honeycomb::Test
