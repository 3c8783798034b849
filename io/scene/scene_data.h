#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "far/base/result.h"
#include "io/scene/rig.h"
#include "io/scene/skin.h"

namespace honeycomb::Io {

/// The polygons of one material of one mesh on one node.
struct ScenePart {
  std::string name;
  std::int32_t node = 0;
  std::int64_t firstVertex = 0;  ///< of SceneData::skin
  std::int64_t endVertex = 0;
  std::vector<std::int64_t> faceOffsets{0};
  std::vector<std::int32_t> indices;  ///< vertices of SceneData::skin
  bool textured = false;
  bool coloured = false;
  bool skinned = false;
};

/// A scene as a file has it, checked: every number finite, every index within its range.
struct SceneData {
  std::vector<RigNode> nodes;
  std::vector<Clip> clips;
  Skin skin;                      ///< of all parts
  std::vector<double> texcoords;  ///< u v per vertex; 0 0 in parts that have none
  std::vector<double> colours;    ///< r g b per vertex; white in parts that have none
  std::vector<ScenePart> parts;
  std::vector<std::string> notes;            ///< what the file has and is left out
  std::vector<std::filesystem::path> files;  ///< that it is read from besides its own, there or not
};

/// Reads a scene with Assimp. Errors: unsupported, where the library was built without it; those of Scene::open.
Result<SceneData> importScene(const std::filesystem::path& path);

}  // namespace honeycomb::Io
