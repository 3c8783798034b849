#include "bench/kit/comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/kit/level_evaluator.h"
#include "bench/kit/limits.h"
#include "bench/kit/meshes.h"
#include "far/schemes/akleman.h"
#include "osd/cpu_evaluator.h"

namespace honeycomb::Bench {
namespace {

using testing::HasSubstr;

constexpr std::int64_t kMemory = 1'000'000'000;
constexpr SamplingOptions kOnce{1, 0};

/// A torus of 64 quads at level 2: 768 vertices.
class ComparisonTest : public testing::Test {
 protected:
  Comparison comparison(std::span<const EvaluatorEntry* const> evaluators, std::int64_t memory = kMemory) const {
    return {{refinement_, mesh_.points, 0, memory, layouts().front()}, evaluators, kOnce};
  }
  Result<Comparisons> compareOne(const EvaluatorEntry& entry, std::int64_t memory = kMemory) const {
    const EvaluatorEntry* one = &entry;
    return compare(comparison({&one, 1}, memory));
  }

 private:
  Mesh mesh_ = torus(64);
  Far::Refinement refinement_ = *Far::refine(*Far::Topology::create(mesh_.polygons), *Far::akleman(), 2);
};

const EvaluatorEntry& entryOf(std::string_view name) {
  for (const EvaluatorEntry& entry : evaluators())
    if (entry.name == name) return entry;
  ADD_FAILURE() << name;
  return evaluators().front();
}

/// The serial evaluator, and one number changed.
template <int Ulps>
Result<Prepared> prepareWrong(const Problem& problem) {
  Result<Prepared> prepared = prepareLevels<Osd::SerialEvaluator>(problem);
  prepared->frame = [right = prepared->frame, refined = problem.refined]() -> Result<void> {
    const Result<void> done = right();
    for (int i = 0; i < Ulps; ++i) refined[17] = std::nextafter(refined[17], 100.0F);
    return done;
  };
  return prepared;
}

Result<Prepared> prepareIdle(const Problem& problem) {
  Result<Prepared> prepared = prepareLevels<Osd::SerialEvaluator>(problem);
  prepared->frame = []() -> Result<void> { return {}; };
  return prepared;
}

TEST_F(ComparisonTest, ANumberThatIsOffByTheLastBitIsFoundWhereBitsAreToBeTheSame) {
  const auto same = compareOne({"right", Agreement::bits, Threads::one, prepareWrong<0>});
  ASSERT_TRUE(same) << same.error().message;
  EXPECT_EQ(same->runs.at(0).difference, 0);
  const auto other = compareOne({"wrong", Agreement::bits, Threads::one, prepareWrong<1>});
  ASSERT_FALSE(other);
  EXPECT_THAT(other.error().message, HasSubstr("wrong: its points differ from the serial evaluator's"));
}

TEST_F(ComparisonTest, RoundingIsAllowedWhereTheOrderOfOperationsDiffers) {
  const auto rounded = compareOne({"rounded", Agreement::rounding, Threads::one, prepareWrong<2>});
  ASSERT_TRUE(rounded) << rounded.error().message;
  EXPECT_GT(rounded->runs.at(0).difference, 0);
  EXPECT_LT(rounded->runs.at(0).difference, kMostDifference);
  EXPECT_FALSE(compareOne({"wrong", Agreement::rounding, Threads::one, prepareWrong<1000>}));
}

TEST_F(ComparisonTest, AnEvaluatorThatWritesNothingIsFoundThoughMemoryIsShared) {
  EXPECT_FALSE(compareOne({"idle", Agreement::rounding, Threads::one, prepareIdle}));
}

TEST_F(ComparisonTest, EveryEvaluatorIsMeasuredOrSkippedWithAReason) {
  std::vector<const EvaluatorEntry*> all;
  for (const EvaluatorEntry& entry : evaluators()) all.push_back(&entry);
  const auto compared = compare(comparison(all));
  ASSERT_TRUE(compared) << compared.error().message;
  EXPECT_EQ(compared->runs.size() + compared->skips.size(), all.size());
  for (const Skip& skip : compared->skips) EXPECT_NE(skip.why, "") << skip.evaluator;
  for (const Bench::Run& run : compared->runs) {
    EXPECT_GT(run.nsPerVertex.min, 0) << run.evaluator;
    EXPECT_LE(run.nsPerVertex.min, run.nsPerVertex.median) << run.evaluator;
    EXPECT_LE(run.nsPerVertex.median, run.nsPerVertex.max) << run.evaluator;
    EXPECT_NEAR(static_cast<double>(run.vertices), 768, 768 / 10.0) << run.evaluator;
    EXPECT_GT(run.tableBytes, 0) << run.evaluator;
  }
  EXPECT_EQ(compared->limits.size(), limits().size());
  for (const Limit& limit : compared->limits) EXPECT_GT(limit.gbPerSecond.median, 0) << limit.name;
}

TEST_F(ComparisonTest, AFlattenedTableThatDoesntFitIsSkipped) {
  const auto compared = compareOne(entryOf("csr"), 1000);
  ASSERT_TRUE(compared) << compared.error().message;
  EXPECT_TRUE(compared->runs.empty());
  ASSERT_EQ(compared->skips.size(), 1U);
  EXPECT_THAT(compared->skips[0].why, HasSubstr("1000"));
}

TEST(Sampling, ContestantsTakeTurnsAndEachTurnBeginsWithAnUntimedFrame) {
  std::string order;
  const auto contestant = [&order](char name) {
    Prepared prepared;
    prepared.frame = [&order, name]() -> Result<void> {
      order += name;
      return {};
    };
    return prepared;
  };
  const Prepared a = contestant('a'), b = contestant('b');
  const std::vector<const Prepared*> both{&a, &b};
  const auto timings = sampleInTurns(both, {3, 0});
  ASSERT_TRUE(timings);
  EXPECT_EQ(order, "aabbaabbaabb");
  EXPECT_EQ(timings->at(0).frameMs.size(), 3U);
  EXPECT_EQ(timings->at(1).framesTimed, 3);
}

TEST(Sampling, TheMiddleOfAnEvenCountIsTheLowerOne) {
  const Spread odd = spreadOf({3, 1, 2}), even = spreadOf({4, 1, 3, 2});
  EXPECT_EQ(odd.median, 2);
  EXPECT_EQ(even.median, 2);
  EXPECT_EQ(even.min, 1);
  EXPECT_EQ(even.max, 4);
}

}  // namespace
}  // namespace honeycomb::Bench
