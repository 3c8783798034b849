#include "io/mesh_output.h"

#include <array>

#include "io/by_extension.h"
#include "io/glb_writer.h"
#include "io/ply_writer.h"

namespace honeycomb::Io {
namespace {

constexpr std::array kMeshOutputs{MeshOutput{".obj", writeObj<float>, writeObj<double>},
                                  MeshOutput{".ply", writePly<float>, writePly<double>},
                                  MeshOutput{".glb", writeGlb<float>, writeGlb<double>}};

}  // namespace

Result<const MeshOutput*> meshOutput(const std::filesystem::path& path) {
  return byExtension(kMeshOutputs, "written meshes", path);
}

}  // namespace honeycomb::Io
