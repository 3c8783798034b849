#pragma once

#include <filesystem>

#include "far/base/result.h"
#include "io/obj.h"
#include "io/pc2.h"

namespace honeycomb::Demo {

/// A mesh and how its vertices move.
struct Animation {
  std::string name;  ///< of the mesh's file
  Io::Mesh mesh;
  Io::Pc2Reader cache;
};

/// Errors: those of readObj and Pc2Reader::open; invalidFile when the cache moves another number of points.
Result<Animation> loadAnimation(const std::filesystem::path& mesh, const std::filesystem::path& cache);

/// The points of frames 0..frameCount-1, one frame after the other: what a camera that stays put must hold.
Result<std::vector<float>> allPoints(const Animation& animation, std::int32_t frameCount);

}  // namespace honeycomb::Demo
