#include "io/scene/scene_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "io/mapped_file.h"
#include "io/scene/scene.h"

namespace honeycomb::Io {
namespace {

constexpr std::size_t kSceneHeadBytes = 4096;
constexpr std::size_t kMostSceneBytes = std::size_t{1} << 30U;  // Assimp holds several copies in memory

/// A format that Assimp reads; `begins` is one of the texts that its first bytes hold. MD5 and OFF are left out:
/// damaged files of theirs make Assimp 5.2 read past its arrays, or ask for any amount of memory.
struct SceneFormat {
  std::string_view extension;
  std::array<std::string_view, 3> begins;  // empty ones don't count; all empty: anything
};

constexpr std::array kSceneFormats{SceneFormat{".gltf", {"{"}},
                                   SceneFormat{".glb", {"glTF"}},
                                   SceneFormat{".fbx", {"Kaydara FBX Binary", "FBXHeader", "; FBX"}},
                                   SceneFormat{".dae", {"<COLLADA"}},
                                   SceneFormat{".bvh", {"HIERARCHY"}},
                                   SceneFormat{".b3d", {"BB3D"}},
                                   SceneFormat{".x", {"xof "}},
                                   SceneFormat{".ms3d", {"MS3D000000"}},
                                   SceneFormat{".smd", {"version"}},
                                   SceneFormat{".iqm", {"INTERQUAKEMODEL"}},
                                   SceneFormat{".ogex", {"Metric", "GeometryNode", "Node"}},
                                   SceneFormat{".3ds", {"MM"}},
                                   SceneFormat{".lwo", {"FORM"}},
                                   SceneFormat{".stl", {}}};

const SceneFormat* sceneFormat(const std::filesystem::path& path) {
  const std::string extension = lowerExtension(path);
  const auto found = std::find_if(kSceneFormats.begin(), kSceneFormats.end(),
                                  [&](const SceneFormat& format) { return format.extension == extension; });
  return found == kSceneFormats.end() ? nullptr : &*found;
}

bool beginsWell(const SceneFormat& format, std::string_view head) {
  if (format.begins[0].empty()) return true;
  return std::any_of(format.begins.begin(), format.begins.end(), [head](std::string_view text) {
    return !text.empty() && head.find(text) != std::string_view::npos;
  });
}

}  // namespace

std::string lowerExtension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

bool isSceneFile(const std::filesystem::path& path) {
  return sceneFormat(path) != nullptr;
}

std::string sceneFormatNames() {
  std::string list;
  for (const SceneFormat& format : kSceneFormats)
    list += fmt::format("{}{}", list.empty() ? "" : ", ", format.extension);
  return list;
}

Result<void> checkSceneFile(const std::filesystem::path& path) {
  const SceneFormat* format = sceneFormat(path);
  if (!format)
    return fail(ErrorCode::invalidFile,
                fmt::format("{}: is no scene; give one of {}", path.string(), sceneFormatNames()));
  const Result<MappedFile> file = MappedFile::open(path);
  if (!file) return tl::unexpected(file.error());
  const std::string_view text = file->text();
  if (text.size() > kMostSceneBytes)
    return fail(ErrorCode::tooLarge,
                fmt::format("{}: has {} bytes, more than 2^30; export its mesh as PLY or OBJ and its "
                            "animation as a PC2 or MDD cache",
                            path.string(), text.size()));
  if (!beginsWell(*format, text.substr(0, kSceneHeadBytes)))
    return fail(ErrorCode::invalidFile,
                fmt::format("{}: {} as no {} file does; give it the ending of its format", path.string(),
                            text.empty() ? "is empty" : "begins", format->extension));
  return {};
}

}  // namespace honeycomb::Io
