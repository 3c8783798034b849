#include "apps/cli/mesh_output.h"

#include <fmt/format.h>

#include <array>

#include "apps/cli/chain.h"
#include "apps/cli/formats.h"
#include "io/glb_writer.h"
#include "io/ply_writer.h"

namespace honeycomb::Cli {
namespace {

constexpr std::array kMeshOutputs{MeshOutput{".obj", Io::writeObj<float>, Io::writeObj<double>},
                                  MeshOutput{".ply", Io::writePly<float>, Io::writePly<double>},
                                  MeshOutput{".glb", Io::writeGlb<float>, Io::writeGlb<double>}};

}  // namespace

Result<const MeshOutput*> meshOutput(const std::filesystem::path& path) {
  const std::string extension = lowerExtension(path);
  for (const MeshOutput& format : kMeshOutputs)
    if (format.name == extension) return &format;
  return fail(ErrorCode::invalidOption, fmt::format("{}: written meshes end in {}; give a file of that kind",
                                                    path.string(), names(kMeshOutputs)));
}

}  // namespace honeycomb::Cli
