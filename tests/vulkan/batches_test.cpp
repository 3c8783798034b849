// Every kind of batch, in every layout, against the reference bit for bit.
#include <cmath>

#include "fixture.h"
#include "osd/vulkan/session.h"
#include "runs.h"
#include "tests/support/random_tables.h"

namespace honeycomb::VulkanTests {
namespace {

using Test::randomNumbers;
using Test::randomTable;
using Test::TableShape;

class BatchesTest : public VulkanTest {
 protected:
  testing::AssertionResult agree(const TableShape& shape, const Osd::BufferDescriptor& control,
                                 const Osd::BufferDescriptor& refined) {
    auto evaluator = makeEvaluator();
    return agrees(evaluator, {randomTable(shape)}, control, refined);
  }
  testing::AssertionResult agree(const TableShape& shape) { return agree(shape, {}, {}); }
};

TEST_F(BatchesTest, CirculantsOfEverySideCount) {
  for (const std::int32_t sides : {3, 4, 5, 6, 7, 8, 9, 13, 16, 31, 63, 64}) {
    EXPECT_TRUE(agree({.circulants = {{sides, 201}}})) << sides << " sides";
  }
}

TEST_F(BatchesTest, CirculantsWithFormsOfTheirOwn) {
  EXPECT_TRUE(agree({.circulants = {{4, 201, true}}})) << "quads";
  EXPECT_TRUE(agree({.circulants = {{6, 201, true}}})) << "hexagons";
}

TEST_F(BatchesTest, OneFace) {
  EXPECT_TRUE(agree({.sourceCount = 3, .circulants = {{3, 1}}}));
}

TEST_F(BatchesTest, AsManyFacesAsAWorkgroupAndOneMoreOrLess) {
  for (const std::int32_t faces : {63, 64, 65}) EXPECT_TRUE(agree({.circulants = {{6, faces}}})) << faces << " faces";
}

TEST_F(BatchesTest, ManyFaces) {
  EXPECT_TRUE(agree({.sourceCount = 40000, .circulants = {{4, 3000}, {6, 20001}}}));
}

TEST_F(BatchesTest, LargeFacesByProjections) {
  for (const std::int32_t corners : {65, 256, 257, 512, 1000, 100000}) {
    EXPECT_TRUE(agree({.projected = {corners}})) << corners << " corners";
  }
}

TEST_F(BatchesTest, SeveralLargeFaces) {
  EXPECT_TRUE(agree({.projected = {65, 1000, 300, 66, 513}}));
}

TEST_F(BatchesTest, RowsThatReadTheSumsOfLargeFaces) {
  EXPECT_TRUE(agree({.projected = {65, 1000, 300}, .summedRows = 500}));
  EXPECT_TRUE(agree({.circulants = {{6, 50}}, .summedRows = 70}));
  EXPECT_TRUE(agree({.circulants = {{6, 50}}, .projected = {100000}, .looseRows = 90, .summedRows = 1}));
}

TEST_F(BatchesTest, HalvesOfLargeFaces) {
  EXPECT_TRUE(agree({.halfProjected = {65, 1000, 100, 513}}));
}

TEST_F(BatchesTest, DenseRowsOfEveryWidth) {
  for (const std::int32_t width : {1, 2, 3, 4, 7, 16}) {
    EXPECT_TRUE(agree({.dense = {{width, 201}}})) << "width " << width;
  }
}

TEST_F(BatchesTest, SeveralBatchesOfDenseRows) {
  EXPECT_TRUE(agree({.dense = {{4, 65}, {2, 1}, {4, 3000}, {7, 64}}}));
}

TEST_F(BatchesTest, LooseRows) {
  EXPECT_TRUE(agree({.looseRows = 1234}));
}

TEST_F(BatchesTest, AllKindsTogetherInEveryLength) {
  const TableShape shape{
      .circulants = {{4, 50}, {5, 33}, {6, 100}}, .projected = {65, 700}, .dense = {{2, 40}, {4, 70}}, .looseRows = 77};
  for (const std::int32_t length : {1, 2, 3, 4, 7}) {
    EXPECT_TRUE(agree(shape, {0, length, length}, {0, length, length})) << "length " << length;
  }
}

TEST_F(BatchesTest, OffsetsAndStrides) {
  const TableShape shape{
      .circulants = {{4, 50}, {5, 33}}, .projected = {300}, .halfProjected = {80}, .dense = {{3, 70}}, .looseRows = 77};
  EXPECT_TRUE(agree(shape, {0, 3, 4}, {0, 3, 4}));
  EXPECT_TRUE(agree(shape, {5, 3, 8}, {2, 3, 3}));
  EXPECT_TRUE(agree(shape, {0, 3, 3}, {7, 3, 11}));
  EXPECT_TRUE(agree(shape, {1, 1, 5}, {3, 1, 2}));
  EXPECT_TRUE(agree(shape, {3, 7, 9}, {1, 7, 8}));
}

TEST_F(BatchesTest, ValuesOfAllMagnitudes) {
  const Far::LevelTable table = randomTable({.circulants = {{3, 300}, {4, 300, true}, {6, 300}, {6, 300, true}},
                                             .projected = {300},
                                             .dense = {{4, 300}},
                                             .looseRows = 300});
  auto evaluator = makeEvaluator();
  auto session = Osd::VulkanSession::create(evaluator, *evaluator.upload(std::vector{&table}, nullptr));
  ASSERT_TRUE(session) << session.error().message;
  auto in = randomNumbers(3000);
  for (std::size_t i = 0; i < in.size(); ++i) in[i] = std::ldexp(in[i], static_cast<int>(i % 241) - 120);
  for (std::size_t i = 0; i < in.size(); i += 5) in[i] = i % 2 == 0 ? 0.0F : -0.0F;
  std::vector<float> out(session->refined().size());
  ASSERT_TRUE(session->refine(in, out));
  EXPECT_TRUE(sameBits(expectedPoints({table}, in, {}, {}), out));
}

}  // namespace
}  // namespace honeycomb::VulkanTests
