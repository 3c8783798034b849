// Table files on the device, uploaded from where they stand: the same bits as the serial evaluator's of the refinement.
#include "tests/io/table_files.h"
#include "tile_fixture.h"

namespace honeycomb::VulkanTests {
namespace {

class TableFileTest : public TilesTest {
 protected:
  void expectPoints(Result<Osd::VulkanTable> table, const std::vector<float>& expected,
                    const std::vector<float>& normals) {
    ASSERT_TRUE(table) << table.error().message;
    Osd::VulkanSession session = must(Osd::VulkanSession::create(*evaluator, std::move(*table)));
    std::ranges::copy(Meshes::randomNumbers(std::ssize(session.control())), session.control().begin());
    must(session.run());
    EXPECT_TRUE(sameBits(expected, session.refined()));
    EXPECT_TRUE(sameBits(normals, session.vertexNormals()));
  }
};

TEST_F(TableFileTest, GivesTheBitsOfTheRefinement) {
  const Far::Refinement refinement = aklemanOf(Meshes::grid(7, 8), 3, true);
  const Far::TileTable tiles =
      must(Far::buildTileTable(refinement, {.scratchPoints = 500, .normals = Far::TileNormalKind::exact}));
  const Io::TableFile file = must(Io::Test::readTable(Io::Test::tableBytes(refinement, &tiles)));
  const Far::LevelTables levels = must(file.levels());
  const std::vector<float> points = Io::Test::pointsBy(Osd::SerialEvaluator(), refinement);
  const std::vector<float> normals = Io::Test::limitNormals(refinement, points);
  expectPoints(evaluator->upload(levels, {.vertexLimits = {.normals = BufferDescriptor{}}}), points, normals);
  expectPoints(evaluator->uploadTiles(levels, *must(file.tiles()), {.normals = BufferDescriptor{}}), points, normals);
}

}  // namespace
}  // namespace honeycomb::VulkanTests
