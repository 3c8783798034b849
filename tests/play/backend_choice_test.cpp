#include "apps/cli/play/backend_choice.h"

#include <gtest/gtest.h>

namespace honeycomb::Cli::Play {
namespace {

/// Frames of the times that each backend takes, until it has settled.
std::string settledOn(double tbb, double vulkan) {
  BackendChoice choice = BackendChoice::parse("auto").value();
  for (int frame = 0; frame < 100 && !choice.settled(); ++frame) choice.took(choice.current() == "tbb" ? tbb : vulkan);
  return choice.settled() ? choice.current() : "none";
}

TEST(BackendChoiceTest, AutoStaysWithTheFastest) {
  EXPECT_EQ(settledOn(1.0, 2.0), "tbb");
  EXPECT_EQ(settledOn(2.0, 1.0), "vulkan");
}

TEST(BackendChoiceTest, AFirstSlowFrameDoesNotCount) {
  BackendChoice choice = BackendChoice::parse("auto").value();
  bool first = true;
  while (!choice.settled()) {
    const bool vulkan = choice.current() == "vulkan";
    choice.took(vulkan && first ? 500 : vulkan ? 1 : 2);
    if (vulkan) first = false;
  }
  EXPECT_EQ(choice.current(), "vulkan");
}

TEST(BackendChoiceTest, ANameStandsForItselfWhateverItTakes) {
  BackendChoice choice = BackendChoice::parse("serial").value();
  EXPECT_TRUE(choice.settled());
  choice.took(1e6);
  EXPECT_EQ(choice.current(), "serial");
  EXPECT_FALSE(choice.drop());
}

TEST(BackendChoiceTest, WhatCannotBeUsedIsDroppedAndTriedAgainAfterARestart) {
  BackendChoice choice = BackendChoice::parse("auto").value();
  while (choice.current() != "vulkan") choice.took(1);
  EXPECT_TRUE(choice.drop());
  EXPECT_EQ(choice.current(), "tbb");
  EXPECT_TRUE(choice.settled());
  EXPECT_FALSE(choice.drop());
  choice.restart();
  EXPECT_FALSE(choice.settled());
}

TEST(BackendChoiceTest, UnknownNamesAreRefusedWithTheKnownOnes) {
  const auto choice = BackendChoice::parse("cuda");
  ASSERT_FALSE(choice);
  EXPECT_EQ(choice.error().code, ErrorCode::invalidOption);
  EXPECT_NE(choice.error().message.find("there is no 'cuda'; choose from: auto, serial"), std::string::npos);
}

}  // namespace
}  // namespace honeycomb::Cli::Play
