#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "io/obj.h"
#include "tests/io/files.h"
#include "tests/io/random_reals.h"

namespace honeycomb::Io::Test {
namespace {

template <class Real>
class ObjRoundTrip : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(ObjRoundTrip, Reals);

TYPED_TEST(ObjRoundTrip, CoordinatesComeBackToTheSameBits) {
  const TemporaryFolder folder;
  const std::vector<TypeParam> positions = randomReals<TypeParam>(30000);
  const std::vector<TypeParam> normals(positions.rbegin(), positions.rend());
  const std::vector<std::int32_t> offsets{0, 3};
  const std::vector<std::int32_t> corners{2, 1, 0};
  const Result<void> written = writeObj<TypeParam>(folder / "a.obj", {positions, normals, offsets, corners});
  ASSERT_TRUE(written) << written.error().message;
  const Result<Mesh> mesh = readObj(folder / "a.obj");
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(bitsOf<TypeParam>(mesh->positions), bitsOf<TypeParam>(positions));
  EXPECT_EQ(bitsOf<TypeParam>(mesh->normals), bitsOf<TypeParam>(normals));
  EXPECT_EQ(mesh->cornerNormals, corners);
}

TYPED_TEST(ObjRoundTrip, ColoursAndTextureCoordinatesComeBackToTheSameBits) {
  const TemporaryFolder folder;
  const std::vector<TypeParam> numbers = randomReals<TypeParam>(3000);
  const std::vector<std::int32_t> offsets{0, 3};
  const std::vector<std::int32_t> corners{2, 1, 0};
  const std::vector<std::int32_t> cornerTexcoords{1499, 7, -1};
  const Result<void> written =
      writeObj<TypeParam>(folder / "a.obj", {numbers, {}, offsets, corners, numbers, numbers, cornerTexcoords});
  ASSERT_TRUE(written) << written.error().message;
  const Result<Mesh> mesh = readObj(folder / "a.obj");
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(bitsOf<TypeParam>(mesh->positions), bitsOf<TypeParam>(numbers));
  EXPECT_EQ(bitsOf<TypeParam>(mesh->colours), bitsOf<TypeParam>(numbers));
  EXPECT_EQ(bitsOf<TypeParam>(mesh->texcoords), bitsOf<TypeParam>(numbers));
  EXPECT_EQ(mesh->cornerTexcoords, cornerTexcoords);
}

TYPED_TEST(ObjRoundTrip, PolygonsComeBackInOrder) {
  const TemporaryFolder folder;
  constexpr std::int32_t kSides = 70000;
  std::vector<TypeParam> positions(3 * std::size_t{kSides});
  std::vector<std::int32_t> corners{4, 2, 0, 1, 2, 3, 4};
  for (std::int32_t v = 0; v < kSides; ++v) corners.push_back(kSides - 1 - v);
  const std::vector<std::int32_t> offsets{0, 3, 7, 7 + kSides};
  const Result<void> written = writeObj<TypeParam>(folder / "a.obj", {positions, {}, offsets, corners});
  ASSERT_TRUE(written) << written.error().message;
  const Result<Mesh> mesh = readObj(folder / "a.obj");
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(mesh->polygons.indices, corners);
  EXPECT_EQ(mesh->polygons.faceOffsets, std::vector<std::int64_t>(offsets.begin(), offsets.end()));
  EXPECT_TRUE(mesh->normals.empty());
}

}  // namespace
}  // namespace honeycomb::Io::Test
