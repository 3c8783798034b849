#include "apps/cli/play/history.h"

#include <gtest/gtest.h>

#include <limits>

#include "apps/cli/play/comparison.h"

namespace honeycomb::Cli::Play {
namespace {

TEST(HistoryTest, KeepsTheLastValuesOldestFirst) {
  History history;
  EXPECT_TRUE(history.values().empty());
  EXPECT_EQ(history.median(), 0);
  for (int i = 0; i < 130; ++i) history.add(static_cast<float>(i));
  ASSERT_EQ(history.values().size(), History::kLength);
  EXPECT_EQ(history.values().front(), 10);
  EXPECT_EQ(history.last(), 129);
  EXPECT_EQ(history.most(), 129);
  EXPECT_EQ(history.median(), 70);
}

TEST(UnitsBetweenTest, CountsNumbersInBetween) {
  EXPECT_EQ(unitsBetween(1, 1), 0);
  EXPECT_EQ(unitsBetween(0.0F, -0.0F), 0);
  EXPECT_EQ(unitsBetween(1, std::nextafter(1.0F, 2.0F)), 1);
  const float least = std::numeric_limits<float>::denorm_min();
  EXPECT_EQ(unitsBetween(-least, least), 2);
}

}  // namespace
}  // namespace honeycomb::Cli::Play
