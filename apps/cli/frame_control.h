#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "apps/cli/animation_input.h"
#include "apps/cli/central_points.h"
#include "apps/cli/mesh_input.h"

namespace honeycomb::Cli {

/// What turns frames into control points; nothing is allocated once it is warm.
struct FrameStorage {
  std::vector<float> frame;    ///< where the animation has to compute it
  std::vector<float> control;  ///< where it isn't the frame as it stands
};

/// The control points of the animation's frame `f`, or of the mesh as it stands where there is no animation: its
/// vertices, then central control vertices where they are given. In `storage` or the animation's own memory.
/// Errors: those of reading the frame, naming its file.
Result<std::span<const float>> controlPoints(const MeshInput& input, const Animation* animation,
                                             const CentralPoints& central, std::int32_t f, FrameStorage& storage);

}  // namespace honeycomb::Cli
