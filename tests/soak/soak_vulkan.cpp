// Frames on the device, three on their way, by tiles with fast normals: soak_vulkan [FRAMES]
#include <vector>

#include "osd/vulkan/context.h"
#include "osd/vulkan/evaluator.h"
#include "osd/vulkan/frames.h"
#include "tests/soak/soak.h"
#include "tests/support/must.h"
#include "tests/support/random_tables.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"

int main(int argc, char** argv) {
  using namespace honeycomb;
  const Far::Refinement refinement =
      Test::refined(Test::torus(6, 6), Test::schemeCase(Test::NamedTension::paper).scheme, 2);
  const Far::TileTable tiles =
      Test::must(Far::buildTileTable(refinement, {.scratchPoints = 300, .normals = Far::TileNormalKind::fast}));
  std::vector<float> control = Test::randomNumbers(3 * std::int64_t{refinement.level(0).pointCount()});
  const Osd::VulkanContext context = Test::must(Osd::VulkanContext::create({}));
  Osd::VulkanEvaluator evaluator = Test::must(Osd::VulkanEvaluator::create(context.device()));
  const Osd::VulkanTable table =
      Test::must(evaluator.uploadTiles(refinement, tiles, {.normals = Osd::BufferDescriptor{}}));
  Osd::VulkanFrames frames = Test::must(Osd::VulkanFrames::create(evaluator, table, {.framesInFlight = 3}));
  return Test::soak("Vulkan frames", argc, argv, [&](std::uint32_t frame) {
    control[frame % control.size()] += 0.001F;
    Test::must(frames.submit(control));
  });
}
