// Frames level after level, then by tiles with fast normals, on all threads: soak_threads [FRAMES]
#include <vector>

#include "far/base/index.h"
#include "osd/cpu_evaluator.h"
#include "osd/tile_evaluator.h"
#include "tests/soak/soak.h"
#include "tests/support/must.h"
#include "tests/support/random_tables.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"

int main(int argc, char** argv) {
  using namespace honeycomb;
  const Far::Refinement refinement =
      Test::refined(Test::torus(40, 40), Test::schemeCase(Test::NamedTension::paper).scheme, 2);
  const Far::TileTable tiles =
      Test::must(Far::buildTileTable(refinement, {.scratchPoints = 1000, .normals = Far::TileNormalKind::fast}));
  std::vector<float> control = Test::randomNumbers(3 * std::int64_t{refinement.level(0).pointCount()});
  std::vector<float> points(3 * at(refinement.last().pointCount())), normals(points.size());
  Osd::TbbEvaluator levels;
  Osd::TileEvaluator evaluator;
  return Test::soak("levels and tiles on threads", argc, argv, [&](std::uint32_t frame) {
    control[frame % control.size()] += 0.001F;
    Test::must(levels.evaluate<float>(refinement, tiles.lastLevel, {control, {}}, {points, {}}));
    Test::must(evaluator.evaluate<float>(refinement, tiles, tiles.lastLevel, {control, {}}, {points, {}},
                                         {{normals, {}}, {}}));
  });
}
