#include "apps/cli/play/clock.h"

#include <gtest/gtest.h>

namespace honeycomb::Cli::Play {
namespace {

/// Ten frames, ten a second.
PlayClock tenFrames() {
  return {10, 10};
}

TEST(PlayClockTest, PlaysFramesAsTimeGoesBy) {
  PlayClock clock = tenFrames();
  EXPECT_EQ(clock.frame(), 0);
  clock.advance(0.35);
  EXPECT_EQ(clock.frame(), 3);
}

TEST(PlayClockTest, StandsUntilItIsToldToGoOn) {
  PlayClock clock = tenFrames();
  clock.toggle();
  clock.advance(5);
  EXPECT_EQ(clock.frame(), 0);
  clock.toggle();
  clock.advance(0.15);
  EXPECT_EQ(clock.frame(), 1);
}

TEST(PlayClockTest, LoopsInBothDirections) {
  PlayClock clock = tenFrames();
  clock.advance(1.25);
  EXPECT_EQ(clock.frame(), 2);
  clock.setSpeed(-1);
  clock.advance(0.35);
  EXPECT_EQ(clock.frame(), 9);
  EXPECT_TRUE(clock.playing());
}

TEST(PlayClockTest, WithoutALoopItStopsAtTheEndsAndBeginsAgain) {
  PlayClock clock = tenFrames();
  clock.setLoop(false);
  clock.advance(3);
  EXPECT_EQ(clock.frame(), 9);
  EXPECT_FALSE(clock.playing());
  clock.toggle();
  EXPECT_EQ(clock.frame(), 0);
  clock.setSpeed(-2);
  clock.advance(3);
  EXPECT_EQ(clock.frame(), 0);
  EXPECT_FALSE(clock.playing());
}

TEST(PlayClockTest, StepsStandStillAndGoRoundOnlyInALoop) {
  PlayClock clock = tenFrames();
  clock.step(-1);
  EXPECT_EQ(clock.frame(), 9);
  EXPECT_FALSE(clock.playing());
  clock.step(2);
  EXPECT_EQ(clock.frame(), 1);
  clock.setLoop(false);
  clock.step(-5);
  EXPECT_EQ(clock.frame(), 0);
}

TEST(PlayClockTest, ScrubbingIsHeldWithinTheAnimation) {
  PlayClock clock = tenFrames();
  clock.scrub(7);
  EXPECT_EQ(clock.frame(), 7);
  clock.scrub(70);
  EXPECT_EQ(clock.frame(), 9);
  clock.scrub(-1);
  EXPECT_EQ(clock.frame(), 0);
}

TEST(PlayClockTest, SpeedHasLimits) {
  PlayClock clock = tenFrames();
  clock.setSpeed(1000);
  EXPECT_EQ(clock.speed(), 16);
  clock.setSpeed(-1e-9);
  EXPECT_EQ(clock.speed(), -1.0 / 16);
}

TEST(PlayClockTest, AnotherAnimationGoesOnWhereItHasThatFrame) {
  PlayClock clock = tenFrames();
  clock.advance(0.65);
  clock.change(20, 5);
  EXPECT_EQ(clock.frame(), 6);
  clock.change(3, 5);
  EXPECT_EQ(clock.frame(), 0);
}

}  // namespace
}  // namespace honeycomb::Cli::Play
