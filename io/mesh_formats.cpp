#include "io/mesh_formats.h"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "io/obj.h"
#include "io/ply.h"
#include "io/scene/scene.h"
#include "io/scene/scene_format.h"

namespace honeycomb::Io {
namespace {

struct MeshFormat {
  std::string_view name;
  ReadMesh read;
};
constexpr std::array kMeshFormats{MeshFormat{".obj", readObj}, MeshFormat{".ply", readPly}};

Result<Mesh> readSceneMesh(const std::filesystem::path& path, std::vector<std::string>& notes) {
  const Result<Scene> scene = Scene::open(path);
  if (!scene) return tl::unexpected(scene.error());
  Result<SceneMesh> mesh = scene->mesh({});
  if (!mesh) return tl::unexpected(mesh.error());
  notes.insert(notes.end(), scene->notes().begin(), scene->notes().end());
  notes.insert(notes.end(), mesh->notes.begin(), mesh->notes.end());
  return std::move(mesh->mesh);
}

Result<Mesh> readByExtension(const std::filesystem::path& path, std::vector<std::string>& notes) {
  if (isSceneFile(path)) return readSceneMesh(path, notes);
  return meshReader(path).and_then([&path](ReadMesh read) { return read(path); });
}

}  // namespace

Result<ReadMesh> meshReader(const std::filesystem::path& path) {
  const std::string extension = lowerExtension(path);
  for (const MeshFormat& format : kMeshFormats)
    if (format.name == extension) return format.read;
  return fail(ErrorCode::invalidOption,
              fmt::format("{}: mesh files end in {}; give a file of that kind", path.string(), meshInputNames()));
}

std::string meshInputNames() {
  std::string names;
  for (const MeshFormat& format : kMeshFormats) names += fmt::format("{}, ", format.name);
  return names + sceneFormatNames();
}

Result<Mesh> readAnyMesh(const std::filesystem::path& path, std::vector<std::string>& notes) {
  Result<Mesh> mesh = readByExtension(path, notes);
  const std::string name = path.string();
  if (!mesh && mesh.error().message.find(name) == std::string::npos)
    mesh.error().message = fmt::format("{}: {}", name, mesh.error().message);
  return mesh;
}

}  // namespace honeycomb::Io
