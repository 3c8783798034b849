#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/mesh.h"
#include "io/scene/scene_data.h"

namespace honeycomb::Io {

/// Parts of a scene as one mesh, without positions: these follow from the skin.
struct WeldedMesh {
  Mesh mesh;
  Skin skin;                       ///< one vertex of the mesh after another
  std::vector<std::string> notes;  ///< what was joined or left out
  std::int64_t fileVertices = 0;   ///< before any were joined
};

/// Joins the vertices of the parts that weldVertices finds to be one; `tolerance` in diagonals of their bounding box.
/// Corners keep the texture coordinates of the vertices they had, one number for equal ones at one vertex; a vertex has
/// the colour of the first. Faces that collapse are left out.
WeldedMesh weldParts(const SceneData& scene, const std::vector<const ScenePart*>& parts, double tolerance);

}  // namespace honeycomb::Io
