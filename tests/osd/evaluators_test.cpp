#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "osd/cpu_evaluator.h"
#include "tests/support/golden.h"
#include "tests/support/refined.h"
#include "tests/support/same_bits.h"
#include "tests/support/scheme_list.h"
#include "tests/support/shapes.h"
#include "tests/support/table_rows.h"

namespace honeycomb::Test {
namespace {

constexpr std::uint64_t kMeshes = meshes(100);

template <class Real>
class Evaluators : public testing::Test {};

using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(Evaluators, Reals);

/// A value that no evaluation gives, to find numbers that were written without need.
template <class Real>
constexpr Real kSentinel = static_cast<Real>(-12345.5);

/// Buffers of exactly the numbers the descriptor needs, so that a sanitizer sees any step outside.
template <class Real>
struct Buffers {
  Buffers(std::int64_t sources, std::int64_t targets, const Osd::BufferDescriptor& in, const Osd::BufferDescriptor& out,
          Random& random)
      : source(static_cast<std::size_t>(in.extent(sources))),
        target(static_cast<std::size_t>(out.extent(targets)), kSentinel<Real>),
        inDesc(in),
        outDesc(out) {
    for (Real& x : source) x = static_cast<Real>(random.symmetric());
  }
  Osd::Points<Real> in() const { return {source, inDesc}; }
  Osd::PointsOut<Real> out() { return {target, outDesc}; }

  std::vector<Real> source;
  std::vector<Real> target;
  Osd::BufferDescriptor inDesc;
  Osd::BufferDescriptor outDesc;
};

Osd::BufferDescriptor randomDescriptor(Random& random, std::int32_t length) {
  const auto offset = static_cast<std::int32_t>(random.below(4));
  return {offset, length, length + static_cast<std::int32_t>(random.below(4))};
}

Osd::BufferDescriptor packed(std::int32_t length) {
  return {0, length, length};
}

/// Serial, on vectors and threaded, the last level from the control points: the same bits in buffers of exact size.
template <class Real>
void compareEvaluators(const Far::Refinement& refinement, Random& random) {
  const std::int32_t last = refinement.levelCount();
  for (const std::int32_t length : {1, 2, 3, 4, 7}) {
    Buffers<Real> serial(refinement.level(0).pointCount(), refinement.last().pointCount(),
                         randomDescriptor(random, length), randomDescriptor(random, length), random);
    Buffers<Real> vectors = serial;
    Buffers<Real> threaded = serial;
    Osd::SerialEvaluator one;
    Osd::SimdEvaluator simd;
    Osd::TbbEvaluator all;
    ASSERT_TRUE(one.evaluate(refinement, last, serial.in(), serial.out()).has_value());
    ASSERT_TRUE(simd.evaluate(refinement, last, vectors.in(), vectors.out()).has_value());
    ASSERT_TRUE(all.evaluate(refinement, last, threaded.in(), threaded.out()).has_value());
    ASSERT_TRUE(sameBits(serial.target, vectors.target)) << "vectors, length " << length;
    ASSERT_TRUE(sameBits(serial.target, threaded.target)) << "threads, length " << length;
  }
}

TYPED_TEST(Evaluators, GiveTheSameBitsOnRandomMeshes) {
  for (const auto boundary : {ReferenceBoundary::brick, ReferenceBoundary::eq16, ReferenceBoundary::drop}) {
    const SchemeCase scheme = schemeCase(NamedTension::paper, boundary);
    for (std::uint64_t seed = 0; seed < kMeshes; ++seed) {
      SCOPED_TRACE(scheme.name + ", seed " + std::to_string(seed));
      const RandomMesh mesh = randomMesh(seed);
      if (referenceLevel(mesh.mesh, {}, scheme.reference, 1).mesh.faces.empty()) continue;  // `drop` leaves nothing
      Random random(seed);
      const std::int32_t levels = boundary == ReferenceBoundary::drop ? 1 : 3;
      ASSERT_NO_FATAL_FAILURE(compareEvaluators<TypeParam>(refined(mesh, scheme.scheme, levels), random));
    }
  }
}

TYPED_TEST(Evaluators, GiveTheSameBitsUnderEveryScheme) {
  Random random(5);
  for (const PolyMesh& mesh : {torus(30, 20), grid(25, 24)}) {
    for (const ListedScheme& scheme : listedSchemes()) {
      SCOPED_TRACE(scheme.name);
      ASSERT_NO_FATAL_FAILURE(compareEvaluators<TypeParam>(refinedBy(scheme, toTopology(mesh), 2), random));
    }
  }
}

TYPED_TEST(Evaluators, GiveTheSameBitsOnMeshesLargeEnoughForThreads) {
  Random random(3);
  for (const PolyMesh& mesh : {torus(50, 60), grid(40, 50), prism(7000), fan(4000)}) {
    const Far::Refinement refinement = refined(mesh, schemeCase(NamedTension::paper).scheme, 2);
    ASSERT_NO_FATAL_FAILURE(compareEvaluators<TypeParam>(refinement, random));
  }
}

TYPED_TEST(Evaluators, GiveTheSameLimitBits) {
  for (const PolyMesh& mesh : {torus(50, 60), grid(40, 50), prism(7000)}) {
    const Far::Refinement refinement = refined(mesh, schemeCase(NamedTension::paper).scheme, 1, {}, true);
    const std::vector<TypeParam> points = pack<TypeParam>(levelPoints<double>(refinement, 1, mesh.points));
    const auto evaluate = [&](auto& evaluator) {
      const Osd::Points<TypeParam> in{points, packed(3)};
      const auto vertexNumbers = 3 * static_cast<std::size_t>(refinement.last().topology.vertexCount());
      const auto faceNumbers = 3 * static_cast<std::size_t>(refinement.last().topology.faceCount());
      std::vector<std::vector<TypeParam>> out = {
          std::vector<TypeParam>(vertexNumbers), std::vector<TypeParam>(vertexNumbers),
          std::vector<TypeParam>(faceNumbers), std::vector<TypeParam>(faceNumbers)};
      const auto to = [&out](std::size_t i) { return Osd::PointsOut<TypeParam>{out[i], packed(3)}; };
      EXPECT_TRUE(evaluator.vertexLimits(refinement.limits(), in, to(0), to(1)).has_value());
      EXPECT_TRUE(evaluator.faceLimits(refinement.limits(), in, to(2), to(3)).has_value());
      return out;
    };
    Osd::SerialEvaluator one;
    Osd::SimdEvaluator simd;
    Osd::TbbEvaluator all;
    const auto serial = evaluate(one);
    const auto vectors = evaluate(simd);
    const auto threaded = evaluate(all);
    for (std::size_t i = 0; i < serial.size(); ++i) {
      EXPECT_TRUE(sameBits(serial[i], vectors[i])) << "vectors, output " << i;
      EXPECT_TRUE(sameBits(serial[i], threaded[i])) << "threads, output " << i;
    }
  }
}

TYPED_TEST(Evaluators, ChainTheLevelsTheyCanAlsoDoOneByOne) {
  const PolyMesh mesh = readGoldenMesh("mixed.obj");
  const Far::Refinement refinement = refined(mesh, schemeCase(NamedTension::paper).scheme, 3);
  std::vector<TypeParam> points = pack<TypeParam>(mesh.points);
  Osd::SerialEvaluator evaluator;
  for (std::int32_t k = 1; k <= 3; ++k) {
    std::vector<TypeParam> next(3 * static_cast<std::size_t>(refinement.level(k).topology.vertexCount()));
    ASSERT_TRUE(evaluator
                    .evaluate(refinement.level(k).table, Osd::Points<TypeParam>{points, packed(3)},
                              Osd::PointsOut<TypeParam>{next, packed(3)})
                    .has_value());
    points = next;
    const std::vector<TypeParam> chained = pack<TypeParam>(levelPoints<TypeParam>(refinement, k, mesh.points));
    EXPECT_TRUE(sameBits(points, chained)) << "level " << k;
  }
}

TYPED_TEST(Evaluators, TouchOnlyTheDescribedNumbers) {
  const PolyMesh mesh = readGoldenMesh("grid.obj");
  const Far::Refinement refinement = refined(mesh, schemeCase(NamedTension::paper).scheme, 2);
  Random random(11);
  for (const std::int32_t length : {1, 2, 3, 4, 7}) {
    const Osd::BufferDescriptor out{5, length, length + 3};
    Buffers<TypeParam> b(refinement.level(0).topology.vertexCount(), refinement.last().topology.vertexCount(),
                         {2, length, length + 1}, out, random);
    Osd::TbbEvaluator evaluator;
    ASSERT_TRUE(evaluator.evaluate(refinement, 2, b.in(), b.out()).has_value());
    for (std::size_t i = 0; i < b.target.size(); ++i) {
      const bool described =
          i >= 5 && (i - 5) % static_cast<std::size_t>(length + 3) < static_cast<std::size_t>(length);
      ASSERT_EQ(b.target[i] != kSentinel<TypeParam>, described) << "length " << length << ", number " << i;
    }
  }
}

TYPED_TEST(Evaluators, TreatEveryValueOfAPointAlike) {
  // A primvar of length 7 gives for each of its values what that value gives alone.
  const PolyMesh mesh = readGoldenMesh("honeycomb.obj");
  const Far::Refinement refinement = refined(mesh, schemeCase(NamedTension::paper).scheme, 2);
  const auto sources = refinement.level(0).topology.vertexCount();
  const auto targets = refinement.last().topology.vertexCount();
  Random random(12);
  Buffers<TypeParam> wide(sources, targets, packed(7), packed(7), random);
  Osd::SerialEvaluator evaluator;
  ASSERT_TRUE(evaluator.evaluate(refinement, 2, wide.in(), wide.out()).has_value());
  for (std::int32_t value = 0; value < 7; ++value) {
    std::vector<TypeParam> single(static_cast<std::size_t>(targets));
    ASSERT_TRUE(evaluator
                    .evaluate(refinement, 2, Osd::Points<TypeParam>{wide.source, {value, 1, 7}},
                              Osd::PointsOut<TypeParam>{single, packed(1)})
                    .has_value());
    for (std::int32_t v = 0; v < targets; ++v) ASSERT_EQ(at(single, v), at(wide.target, 7 * v + value)) << value;
  }
}

template <class Real>
void compareWithRows(const PolyMesh& mesh, const std::vector<std::size_t>& tags, const SchemeCase& scheme) {
  const Far::Refinement refinement = refined(mesh, scheme.scheme, 2, tags);
  auto expected = applyRows(expandRows(refinement.level(1).table), mesh.points);
  expected = applyRows(expandRows(refinement.level(2).table), expected);
  const auto actual = levelPoints<Real>(refinement, 2, mesh.points);
  for (std::size_t v = 0; v < expected.size(); ++v) {
    ASSERT_LT(distance(expected[v], actual[v]), sizeof(Real) == 4 ? 4e-6 : 2e-14) << "vertex " << v;
  }
}

TYPED_TEST(Evaluators, GiveWhatTheRowsOfTheTableSay) {
  for (const auto boundary : {ReferenceBoundary::brick, ReferenceBoundary::eq16}) {
    const SchemeCase scheme = schemeCase(NamedTension::paper, boundary);
    for (std::uint64_t seed = 0; seed < kMeshes; ++seed) {
      SCOPED_TRACE(scheme.name + ", seed " + std::to_string(seed));
      const RandomMesh random = randomMesh(seed);
      ASSERT_NO_FATAL_FAILURE(compareWithRows<TypeParam>(random.mesh, random.cornerTags, scheme));
    }
    ASSERT_NO_FATAL_FAILURE(compareWithRows<TypeParam>(prism(300), {}, scheme));
    ASSERT_NO_FATAL_FAILURE(compareWithRows<TypeParam>(fan(140), {}, scheme));
  }
}

TYPED_TEST(Evaluators, CanBeUsedAgainForOtherTablesAndPrecisions) {
  Osd::TbbEvaluator used;
  for (const char* shape : {"mixed", "cube", "torus", "grid", "cube"}) {
    const PolyMesh mesh = readGoldenMesh(std::string(shape) + ".obj");
    const Far::Refinement refinement = refined(mesh, schemeCase(NamedTension::paper).scheme, 3);
    const std::vector<TypeParam> in = pack<TypeParam>(mesh.points);
    std::vector<TypeParam> out(3 * static_cast<std::size_t>(refinement.last().topology.vertexCount()));
    ASSERT_TRUE(
        used.evaluate(refinement, 3, Osd::Points<TypeParam>{in, packed(3)}, Osd::PointsOut<TypeParam>{out, packed(3)})
            .has_value());
    EXPECT_TRUE(sameBits(out, pack<TypeParam>(levelPoints<TypeParam>(refinement, 3, mesh.points)))) << shape;
  }
}

}  // namespace
}  // namespace honeycomb::Test
