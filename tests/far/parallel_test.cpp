#include "far/base/parallel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <utility>
#include <vector>

#include "far/base/shares.h"

namespace honeycomb::Parallel {
namespace {

using Work = std::vector<std::pair<int, std::int64_t>>;  // worker, item

Work workedBy(Shares<4>& shares, int preferred) {
  Work done;
  shares.work(preferred, [&](int worker, std::int64_t item) { done.emplace_back(worker, item); });
  return done;
}

TEST(Shares, BeginWithTheirOwnAndEndWithTheLastOfOthers) {
  Shares<4> shares(10, 3);
  EXPECT_EQ(workedBy(shares, 1),
            (Work{{1, 3}, {1, 4}, {1, 5}, {1, 9}, {1, 8}, {1, 7}, {1, 6}, {1, 2}, {1, 1}, {1, 0}}));
  EXPECT_EQ(workedBy(shares, 1), Work{}) << "nothing is left for the second of three";
}

TEST(Shares, BelongToOneWorkerEach) {
  Shares<4> shares(3, 3);
  std::vector<int> workers;
  const auto note = [&](int worker, std::int64_t) {
    workers.push_back(worker);
    // While this one works, another thread comes that would be the same worker.
    if (workers.size() == 1) shares.work(5, [&](int other, std::int64_t) { workers.push_back(other); });
  };
  shares.work(2, note);
  EXPECT_THAT(workers, testing::ElementsAre(2, 0, 0));
}

TEST(Parallel, TakesEachItemOnceAndGivesAWorkerToOneThreadAtATime) {
  for (const int threads : {1, 2, 5}) {
    const ThreadLimit limit(threads);
    for (const std::int64_t count : {0, 1, 3, 1000}) {
      std::vector<std::atomic<int>> taken(static_cast<std::size_t>(count));
      std::array<std::atomic<bool>, kMostWorkers> busy{};
      std::atomic<int> clashes{0};
      std::atomic<int> highest{0};
      forItems(count, threads, [&](int worker, std::int64_t i) {
        if (busy.at(static_cast<std::size_t>(worker)).exchange(true)) ++clashes;
        ++taken[static_cast<std::size_t>(i)];
        if (worker > highest) highest = worker;
        busy.at(static_cast<std::size_t>(worker)) = false;
      });
      EXPECT_THAT(taken, testing::Each(testing::Eq(1))) << count << " items";
      EXPECT_EQ(clashes, 0);
      EXPECT_LT(highest, threads);
    }
  }
}

}  // namespace
}  // namespace honeycomb::Parallel
