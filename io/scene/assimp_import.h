#pragma once

#include <assimp/scene.h>

#include <string>
#include <unordered_map>
#include <vector>

#include "far/base/result.h"
#include "io/scene/gltf_curves.h"
#include "io/scene/scene_data.h"

namespace honeycomb::Io {

/// What the parts of the conversion from Assimp's scene share.
struct SceneConversion {
  std::string file;  ///< for messages
  const aiScene& scene;
  bool targetsAreOffsets = false;  ///< of meshes with the relative method: COLLADA's are, all others' are shapes
  std::vector<GltfCurve> curves;   ///< that stand in place of what Assimp has
  SceneData data;
  std::unordered_map<std::string, std::int32_t> nodeByName;
};

/// The nodes, parents first. Errors: invalidFile for transforms that are not finite.
Result<void> convertNodes(SceneConversion& conversion);
/// The clips. Errors: invalidFile for keys or times that are not finite, times that don't rise, rotations of no length.
Result<void> convertClips(SceneConversion& conversion);
/// The meshes, each once for every node it hangs on. Errors: invalidFile for indices out of range, bones without a
/// node, weights that are not finite; invalidPositions; tooLarge.
Result<void> convertMeshes(SceneConversion& conversion);

inline tl::unexpected<Error> failScene(const SceneConversion& conversion, const std::string& what) {
  return fail(ErrorCode::invalidFile, conversion.file + ": " + what);
}

inline Vector3 vectorOf(const aiVector3D& v) {
  return {v.x, v.y, v.z};
}
inline Transform transformOf(const aiMatrix4x4& m) {
  return {{m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4}};
}

}  // namespace honeycomb::Io
