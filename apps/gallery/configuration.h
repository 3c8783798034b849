#pragma once

#include <functional>

#include "apps/gallery/model.h"
#include "far/tables/patch_table.h"

namespace honeycomb::Gallery {

/// A natural configuration and a half-box step of it as meshes over the ground.
struct Configuration {
  std::int32_t sides = 0;
  Shape mesh;                  ///< of 4n vertices; face 0 is the n-gon
  Far::PatchTable table;       ///< its n patches; of meshes with the original S2
  Shape finer;                 ///< a step later: 9n vertices
  Far::PatchTable finerTable;  ///< its 4n patches: those round the n-gon are the first spline ring

  /// The faces of the tables that the n-gon is.
  std::int32_t middle = 0;
  std::int32_t finerMiddle = 0;
};

/// `tunedWeight`: of naturalConfiguration() and the step. Errors: those of naturalConfiguration.
Result<Configuration> configuration(std::int32_t sides, double tunedWeight = 0.25);

/// The mesh with its vertices at those heights over the ground.
Shape lifted(const Shape& mesh, const std::function<float(std::size_t vertex, float x, float z)>& height);

}  // namespace honeycomb::Gallery
