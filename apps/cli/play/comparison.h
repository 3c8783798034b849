#pragma once

#include "apps/cli/play/stage.h"

namespace honeycomb::Cli::Play {

/// How far apart two numbers are, in units of the last place: 0 only for the same bits (or zeros of both signs).
double unitsBetween(float a, float b);

/// Refines a frame on serial, tbb and vulkan: the most that two of their numbers are apart, in units of the last place.
/// The stage is left with one of these poses. Errors: of Stage::pose.
Result<double> largestDifference(Stage& stage, std::int32_t frame);

}  // namespace honeycomb::Cli::Play
