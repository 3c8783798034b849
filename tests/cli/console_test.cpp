#include "apps/cli/console.h"

#include <gtest/gtest.h>

#include "apps/cli/progress.h"

namespace honeycomb::Cli {
namespace {

TEST(Console, NumbersAreGroupedByThousands) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1000), "1,000");
  EXPECT_EQ(grouped(1234567), "1,234,567");
  EXPECT_EQ(grouped(-123456), "-123,456");
}

TEST(Console, BytesHaveReadableUnits) {
  EXPECT_EQ(humanBytes(999), "999 bytes");
  EXPECT_EQ(humanBytes(1000), "1.0 kB");
  EXPECT_EQ(humanBytes(999'949), "999.9 kB");
  EXPECT_EQ(humanBytes(999'950), "1.0 MB");
  EXPECT_EQ(humanBytes(31'234'567'890), "31.2 GB");
}

TEST(Progress, LineShowsShareRateAndTimeLeft) {
  EXPECT_EQ(progressLine({"baking", "frames", 0.25, 50, 10}),
            "baking  [######------------------]  25%  5.0 frames/s  0:30 left");
  EXPECT_EQ(progressLine({"writing", "vertices", 1, 8e6, 4}),
            "writing  [########################] 100%  2.0 Mvertices/s  0:00 left");
  EXPECT_EQ(progressLine({"baking", "frames", 0.5, 1, 7200}),
            "baking  [############------------]  50%  0.0 frames/s  2:00:00 left");
}

TEST(Progress, NothingIsGuessedBeforeTheFirstPieceOfWork) {
  EXPECT_EQ(progressLine({"building", "vertices", 0, 0, 3}), "building  [------------------------]   0%");
}

}  // namespace
}  // namespace honeycomb::Cli
