#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "osd/vulkan/evaluator.h"

namespace honeycomb::VulkanTests {

/// Success when both have the same bits; otherwise names the first difference.
testing::AssertionResult sameBits(std::span<const float> expected, std::span<const float> actual);

/// Evaluates a chain of levels with the given layouts on the device and by the reference, and compares every number of
/// the output, those between the described values included.
testing::AssertionResult agrees(Osd::VulkanEvaluator& evaluator, const std::vector<Far::LevelTable>& levels,
                                const Osd::BufferDescriptor& control, const Osd::BufferDescriptor& refined);

/// The reference's result of a chain of levels; what isn't described is zero.
std::vector<float> expectedPoints(const std::vector<Far::LevelTable>& levels, const std::vector<float>& control,
                                  const Osd::BufferDescriptor& controlDesc, const Osd::BufferDescriptor& refinedDesc);

std::vector<const Far::LevelTable*> pointersTo(const std::vector<Far::LevelTable>& levels);

}  // namespace honeycomb::VulkanTests
