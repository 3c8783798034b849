#include "apps/demo/contest.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace honeycomb::ViewerTests {
namespace {

TEST(BitDistance, CountsTheNumbersBetween) {
  EXPECT_EQ(Demo::bitDistance(1.5F, 1.5F), 0U);
  EXPECT_EQ(Demo::bitDistance(1.0F, std::nextafter(1.0F, 2.0F)), 1U);
  EXPECT_EQ(Demo::bitDistance(-0.0F, 0.0F), 1U) << "equal numbers of different bits";
  const float smallest = std::numeric_limits<float>::denorm_min();
  EXPECT_EQ(Demo::bitDistance(-smallest, smallest), 3U);
}

TEST(Contest, TableNamesDifferencesThatAreThere) {
  const std::vector<Demo::Standing> standings{{"serial", 1, 2, 3e6, 0}, {"other", 1, 2, 3e6, 7}};
  const std::string table = Demo::tableOf(standings);
  EXPECT_THAT(table, testing::ContainsRegex("serial .* 3.0 M +0 bits"));
  EXPECT_THAT(table, testing::ContainsRegex("other .* 7 ulp"));
}

}  // namespace
}  // namespace honeycomb::ViewerTests
