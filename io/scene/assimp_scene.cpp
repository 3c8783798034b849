#include <assimp/config.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <new>
#include <system_error>

#include "io/scene/assimp_import.h"
#include "io/scene/scene_format.h"
#include "io/scene/trial.h"

namespace honeycomb::Io {
namespace {

/// What a scene has and nobody here takes.
void noteLeftOut(SceneConversion& conversion) {
  const aiScene& scene = conversion.scene;
  std::string list;
  const auto add = [&list](unsigned count, const char* one, const char* many) {
    if (count > 0) list += fmt::format("{}{} {}", list.empty() ? "" : ", ", count, count == 1 ? one : many);
  };
  add(scene.mNumLights, "light", "lights");
  add(scene.mNumCameras, "camera", "cameras");
  add(scene.mNumMaterials, "material", "materials");
  add(scene.mNumTextures, "embedded texture", "embedded textures");
  if (!list.empty()) conversion.data.notes.push_back(list + ": left out");
}

Result<SceneData> convertScene(const std::filesystem::path& path, const aiScene& scene) {
  SceneConversion conversion{path.string(), scene, lowerExtension(path) == ".dae", {}, {}};
  if (!scene.mRootNode) return failScene(conversion, "has no nodes; give a file with a mesh");
  Result<void> done = convertNodes(conversion);
  if (done) done = convertMeshes(conversion);
  if (done) done = convertClips(conversion);
  if (!done) return tl::unexpected(done.error());
  const auto& parts = conversion.data.parts;
  if (std::all_of(parts.begin(), parts.end(), [](const ScenePart& part) { return part.indices.empty(); }))
    return failScene(conversion, "has no mesh; give a file with faces");
  noteLeftOut(conversion);
  return std::move(conversion.data);
}

/// Nothing that would join, split or limit what is in the file.
constexpr unsigned kAsItStands = 0;

/// Can Assimp read the file without harm? glTF is checked for what it doesn't survive; damaged files of other formats
/// have been seen to crash it, or to keep it for ever, so that they are tried first.
Result<void> checkReading(const std::filesystem::path& path) {
  if (const Result<void> sound = checkSceneFile(path); !sound) return sound;
  const std::string extension = lowerExtension(path);
  if (extension == ".gltf" || extension == ".glb") return {};
  return tryReading(path, [&path] { Assimp::Importer().ReadFile(path.string(), kAsItStands); });
}

/// Assimp's messages, made fit for one line.
std::string oneLine(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; }, ' ');
  return text;
}

}  // namespace

Result<SceneData> importScene(const std::filesystem::path& path) {
  if (const Result<void> safe = checkReading(path); !safe) return tl::unexpected(safe.error());
  try {
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(path.string(), kAsItStands);
    if (scene) return convertScene(path, *scene);
    return fail(ErrorCode::invalidFile, fmt::format("{}: can't be understood: {}; export it anew", path.string(),
                                                    oneLine(importer.GetErrorString())));
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::outOfMemory, fmt::format("{}: the scene does not fit into memory; split it", path.string()));
  } catch (const std::exception& error) {
    return fail(ErrorCode::invalidFile,
                fmt::format("{}: can't be understood: {}; export it anew", path.string(), oneLine(error.what())));
  }
}

}  // namespace honeycomb::Io
