// Plays back a deforming mesh on the CPU: tables once, then every frame of a point cache.
//   cpu_playback MESH.obj FRAMES.pc2 [levels]
#include <honeycomb/far/schemes/akleman.h>
#include <honeycomb/far/tables/refinement.h>
#include <honeycomb/far/tables/tile_table.h>
#include <honeycomb/io/obj.h>
#include <honeycomb/io/pc2.h>
#include <honeycomb/osd/tile_evaluator.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

namespace {

using namespace honeycomb;

template <class T>
T must(Result<T> result) {
  if (result) return std::move(*result);
  std::fprintf(stderr, "%s\n", result.error().message.c_str());
  std::exit(1);
}

double milliseconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::milli>(now).count();
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) {
    std::fprintf(stderr, "usage: cpu_playback MESH.obj FRAMES.pc2 [levels]\n");
    return 1;
  }
  const Io::Mesh mesh = must(Io::readObj(arguments[1]));
  const Io::Pc2Reader frames = must(Io::Pc2Reader::open(arguments[2]));
  const int levels = count > 3 ? std::atoi(arguments[3]) : 3;

  // Once per mesh: its levels, and the tiles that the evaluator goes by.
  const auto topology = must(Far::Topology::create(mesh.polygons));
  const auto refinement = must(Far::refine(topology, must(Far::akleman()), levels));
  const auto tiles = must(Far::buildTileTable(refinement, {.normals = Far::TileNormalKind::fast}));
  const Far::Topology& finest = refinement.level(levels).topology;
  std::printf("%d faces become %d, %d vertices\n", topology.faceCount(), finest.faceCount(), finest.vertexCount());

  // Every frame: positions and normals of the finest level.
  Osd::TileEvaluator evaluator;
  std::vector<float> positions(3 * static_cast<std::size_t>(finest.vertexCount())), normals(positions.size());
  const int frameCount = frames.info().frameCount;
  const double start = milliseconds();
  float lowest = 0, highest = 0;
  for (int f = 0; f < frameCount; ++f) {
    const auto evaluated = evaluator.evaluate<float>(refinement, tiles, levels, {must(frames.frame(f)), {}},
                                                     {positions, {}}, {.normals = {normals, {}}});
    if (!evaluated) must<int>(tl::unexpected(evaluated.error()));
    const auto [least, most] = std::minmax_element(positions.begin(), positions.end());
    lowest = std::min(lowest, *least);
    highest = std::max(highest, *most);
  }
  const double took = milliseconds() - start;
  std::printf("%d frames, %.2f ms each, coordinates from %.4f to %.4f\n", frameCount, took / frameCount, lowest,
              highest);
  return 0;
}
