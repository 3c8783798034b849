#include <fmt/format.h>

#include "io/scene/scene_data.h"

namespace honeycomb::Io {

Result<SceneData> importScene(const std::filesystem::path& path) {
  return fail(
      ErrorCode::unsupported,
      fmt::format("{}: this build reads no scenes; build with Assimp (libassimp-dev) or export an OBJ file and a "
                  "PC2 cache",
                  path.string()));
}

}  // namespace honeycomb::Io
