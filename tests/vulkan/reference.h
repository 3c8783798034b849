#pragma once

#include <vector>

#include "far/tables/level_table.h"
#include "far/tables/limit_table.h"
#include "osd/buffer_descriptor.h"

/// The tables applied by the plainest code there is, in the order of operations that level_table.h and limit_table.h
/// give. Compiled without contraction, like everything in the project.
namespace honeycomb::VulkanTests {

/// Evaluates a level into `target`, which has the numbers of `targetDesc` already.
void evaluateLevel(const Far::LevelTable& table, const std::vector<float>& source,
                   const Osd::BufferDescriptor& sourceDesc, std::vector<float>& target,
                   const Osd::BufferDescriptor& targetDesc);

/// Limit positions and normals of the elements of `rows`.
void evaluateLimits(const Far::LimitRows& rows, const std::vector<float>& source,
                    const Osd::BufferDescriptor& sourceDesc, std::vector<float>& positions,
                    const Osd::BufferDescriptor& positionDesc, std::vector<float>& normals,
                    const Osd::BufferDescriptor& normalDesc);

}  // namespace honeycomb::VulkanTests
