#include <algorithm>

#include "apps/cli/devices.h"
#include "apps/cli/frame_tiles.h"
#include "apps/cli/surface_evaluator.h"
#include "far/schemes/akleman.h"
#include "far/schemes/zhang_wang.h"
#include "io/obj.h"
#include "workplace.h"

namespace honeycomb::Test {
namespace {

using Cli::kTileFrames;
using OpenBackend = Result<std::unique_ptr<Cli::Backend>> (*)();

/// 10,000 quads: 360,000 vertices at level 3, 40,000 at level 1.
class BakeTilesTest : public Workplace {
 protected:
  const std::string obj_ = torusObj(100);
  const Far::Topology control_ = *Far::Topology::create(Io::readObj(file("torus.obj", obj_))->polygons);

  Far::Refinement akleman(int levels) const { return *Far::refine(control_, *Far::akleman(), levels); }
  template <class Real>
  std::vector<Real> bent(int frame) const {
    const std::vector<float> points = bentFrame(obj_, frame);
    return {points.begin(), points.end()};
  }
  static bool deviceIsCpu() {
    const auto devices = Cli::vulkanDevices();
    return devices && std::ranges::all_of(*devices, [](const auto& device) { return device.type == "cpu"; });
  }
  static std::int64_t tileBytes(OpenBackend open, const Far::Refinement& refinement, int frames) {
    return (*open())->frameEvaluators(refinement, frames, 1)->tileBytes;
  }
};

template <class Real>
std::vector<Real> refine(Cli::SurfaceEvaluator& evaluator, const std::vector<Real>& control) {
  Cli::Surface<Real> surface;
  EXPECT_TRUE(evaluator.evaluate(std::span<const Real>(control), surface));
  return {surface.vertices().begin(), surface.vertices().end()};
}

TEST_F(BakeTilesTest, FramesByTilesHaveTheBitsOfSerialOnes) {
  const Far::Refinement refinement = akleman(3);
  const auto serial = *(*Cli::openSerial())->evaluator(refinement, Cli::Normals::none);
  for (const OpenBackend open : {Cli::openSimd, Cli::openTbb}) {
    const auto backend = *open();
    for (const int atOnce : {1, backend->framesAtOnce()}) {
      const auto frames = backend->frameEvaluators(refinement, kTileFrames, atOnce);
      ASSERT_TRUE(frames);
      EXPECT_GT(frames->tileBytes, 0) << backend->name();
      ASSERT_EQ(std::ssize(frames->each), atOnce);
      for (int i = 0; i < atOnce; ++i) {
        Cli::SurfaceEvaluator& evaluator = *frames->each[static_cast<std::size_t>(i)];
        EXPECT_TRUE(refine(evaluator, bent<float>(i)) == refine(*serial, bent<float>(i))) << backend->name() << i;
        EXPECT_TRUE(refine(evaluator, bent<double>(i)) == refine(*serial, bent<double>(i))) << backend->name() << i;
      }
    }
  }
}

TEST_F(BakeTilesTest, FramesByTilesOnADeviceHaveTheBitsOfSerialOnes) {
  const auto backend = Cli::openVulkan();
  if (!backend) GTEST_SKIP() << backend.error().message;
  const Far::Refinement refinement = akleman(3);
  const auto serial = *(*Cli::openSerial())->evaluator(refinement, Cli::Normals::none);
  const auto frames = (*backend)->frameEvaluators(refinement, 1000, 2);
  ASSERT_TRUE(frames) << frames.error().message;
  EXPECT_EQ(frames->tileBytes > 0, deviceIsCpu());
  for (int i = 0; i < 2; ++i) ASSERT_TRUE(frames->stream->submit(bent<float>(i)));
  for (int i = 0; i < 2; ++i) {
    Cli::Surface<float> surface;
    ASSERT_TRUE(frames->stream->collect(surface));
    const std::vector<float> vertices(surface.vertices().begin(), surface.vertices().end());
    EXPECT_TRUE(vertices == refine(*serial, bent<float>(i))) << "frame " << i;
  }
}

TEST_F(BakeTilesTest, ADeviceTakesTilesWhereItIsTheCpuAndTheFramesPayForThem) {
  const Far::Refinement refinement = akleman(2);  // 120,000 points: 134 ms to pay, 0.72 saved a frame
  EXPECT_TRUE(Cli::deviceTilesPay(true, refinement, 187, 1));
  EXPECT_FALSE(Cli::deviceTilesPay(true, refinement, 185, 1));
  EXPECT_FALSE(Cli::deviceTilesPay(false, refinement, 100'000, 1)) << "a GPU";
}

TEST_F(BakeTilesTest, TilesAreBuiltWhereTheFramesAreManyAndThePointsToo) {
  const Far::Refinement large = akleman(3), small = akleman(1);
  EXPECT_GT(tileBytes(Cli::openTbb, large, kTileFrames), 0);
  EXPECT_EQ(tileBytes(Cli::openTbb, large, kTileFrames - 1), 0);
  EXPECT_EQ(tileBytes(Cli::openTbb, small, 100 * kTileFrames), 0);
}

TEST_F(BakeTilesTest, SerialIsTheReferenceAndHasNone) {
  EXPECT_EQ(tileBytes(Cli::openSerial, akleman(3), kTileFrames), 0);
}

TEST_F(BakeTilesTest, RowsThatShareNoWeightsAreRefinedLevelByLevel) {
  const Far::Refinement refinement = *Far::refine(control_, *Far::zhangWang(control_, 3));
  EXPECT_EQ(tileBytes(Cli::openTbb, refinement, kTileFrames), 0);
}

}  // namespace
}  // namespace honeycomb::Test
