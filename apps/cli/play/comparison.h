#pragma once

#include <array>

#include "apps/cli/play/stage.h"

namespace honeycomb::Cli::Play {

/// How far apart two numbers are, in units of the last place: 0 only for the same bits (or zeros of both signs).
double unitsBetween(float a, float b);

/// What are compared.
constexpr std::array<const char*, 3> kComparedBackends{"serial", "tbb", "vulkan"};

/// Refines a frame on all of these: the most that two of their numbers are apart, in units of the last place.
/// The stage is left with one of these poses. Errors: of Stage::pose.
Result<double> largestDifference(Stage& stage, std::int32_t frame);

}  // namespace honeycomb::Cli::Play
