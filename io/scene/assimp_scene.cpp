#include <assimp/config.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <new>
#include <system_error>

#include "io/mapped_file.h"
#include "io/scene/assimp_import.h"
#include "io/scene/gltf_check.h"
#include "io/scene/gltf_curves.h"
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

/// What Assimp is not asked for.
struct Beside {
  GltfCurves gltf;
  std::vector<std::filesystem::path> files;  ///< that the scene is read from besides its own
};

Result<SceneData> convertScene(const std::filesystem::path& path, const aiScene& scene, Beside beside) {
  SceneConversion conversion{
      path.string(), scene, lowerExtension(path) == ".dae", std::move(beside.gltf.curves), {}, {}};
  conversion.data.notes = std::move(beside.gltf.notes);
  conversion.data.files = std::move(beside.files);
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

/// Is it version 2, as far as can be told without reading it?
bool isSecondGltf(std::string_view text) {
  if (text.substr(0, 4) == "glTF") return text.size() > 4 && text[4] == '\2';
  const std::size_t version = text.find("\"version\"");
  const std::size_t value = version == std::string_view::npos ? version : text.find('"', version + 9);
  return value == std::string_view::npos || text.substr(value + 1, 2) != "1.";
}

/// Of a glTF file, checked for what Assimp doesn't survive. Errors: invalidFile, unreadable.
Result<Beside> readGltf(const std::filesystem::path& path) {
  const Result<MappedFile> file = MappedFile::open(path);
  if (!file) return tl::unexpected(file.error());
  // glTF 1.0 names things instead of counting them, and has its own reader in Assimp.
  if (!isSecondGltf(file->text())) return Beside{};
  const Result<GltfDocument> document = GltfDocument::parse(path, file->text());
  if (!document) return tl::unexpected(document.error());
  if (const auto sound = checkGltf(*document); !sound) return tl::unexpected(sound.error());
  Result<GltfCurves> curves = gltfCurves(*document);
  if (!curves) return tl::unexpected(curves.error());
  return Beside{std::move(*curves), document->bufferFiles()};
}

/// Can Assimp read the file without harm? glTF is checked; damaged files of other formats have been seen to crash it,
/// or to keep it for ever, so that they are tried first.
Result<Beside> checkReading(const std::filesystem::path& path) {
  if (const Result<void> sound = checkSceneFile(path); !sound) return tl::unexpected(sound.error());
  const std::string extension = lowerExtension(path);
  if (extension == ".gltf" || extension == ".glb") return readGltf(path);
  return tryReading(path, [&path] { Assimp::Importer().ReadFile(path.string(), kAsItStands); }).map([] {
    return Beside{};
  });
}

/// Assimp's messages, made fit for one line.
std::string oneLine(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; }, ' ');
  return text;
}

}  // namespace

Result<SceneData> importScene(const std::filesystem::path& path) {
  try {
    Result<Beside> beside = checkReading(path);
    if (!beside) return tl::unexpected(beside.error());
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(path.string(), kAsItStands);
    if (scene) return convertScene(path, *scene, std::move(*beside));
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
