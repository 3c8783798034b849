#include "apps/demo/animation.h"

#include <fmt/format.h>

namespace honeycomb::Demo {

Result<Animation> loadAnimation(const std::filesystem::path& mesh, const std::filesystem::path& cache) {
  auto loaded = Io::readObj(mesh);
  if (!loaded) return tl::unexpected(loaded.error());
  auto opened = Io::Pc2Reader::open(cache);
  if (!opened) return tl::unexpected(opened.error());
  if (opened->info().pointCount != loaded->polygons.vertexCount) {
    return fail(ErrorCode::invalidFile,
                fmt::format("{} moves {} points and {} has {} vertices; give the cache that belongs to the mesh",
                            cache.string(), opened->info().pointCount, mesh.string(), loaded->polygons.vertexCount));
  }
  return Animation{mesh.filename().string(), std::move(*loaded), std::move(*opened)};
}

Result<std::vector<float>> allPoints(const Animation& animation, std::int32_t frameCount) {
  std::vector<float> points;
  for (std::int32_t f = 0; f < frameCount; ++f) {
    const auto frame = animation.cache.frame(f);
    if (!frame) return tl::unexpected(frame.error());
    points.insert(points.end(), frame->begin(), frame->end());
  }
  return points;
}

}  // namespace honeycomb::Demo
