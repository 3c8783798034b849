#include <gtest/gtest.h>

#include "apps/viewer/cell_colours.h"
#include "apps/viewer/surface_painter.h"
#include "far/schemes/akleman.h"
#include "osd/cpu_evaluator.h"
#include "tests/viewer/cube.h"
#include "tests/vulkan/fixture.h"

namespace honeycomb::ViewerTests {
namespace {

constexpr Viewer::RendererOptions kPainterSize{120, 90};

class PainterTest : public VulkanTests::VulkanTest {
 protected:
  Far::Refinement refined(std::int32_t levels) const {
    const auto control = Far::Topology::create(cube.polygons());
    return Far::refine(control.value(), Far::akleman().value(), levels, {.limits = true, .memoryLimit = 0}).value();
  }

  Viewer::View viewOf(std::span<const float> points) const {
    Viewer::View view;
    view.bounds = Viewer::boundsOf(points);
    view.camera = Viewer::frameAll(points, {1, 0.6F, 0.8F}, 120.0F / 90.0F);
    return view;
  }

  /// The same picture from points and normals that the CPU made and that were uploaded.
  Viewer::Picture drawnFromHost(const Far::Refinement& refinement, const Viewer::View& view) const {
    const Far::Topology& topology = refinement.last().topology;
    std::vector<float> points(3 * static_cast<std::size_t>(topology.vertexCount()));
    std::vector<float> normals(points.size());
    Osd::SerialEvaluator evaluator;
    EXPECT_TRUE(evaluator.evaluate<float>(refinement, refinement.levelCount(), {cube.points, {}}, {points, {}}));
    EXPECT_TRUE(evaluator.vertexLimits<float>(refinement.limits(), {points, {}}, {}, {normals, {}}));
    auto renderer = Viewer::Renderer::create(context->device(), kPainterSize).value();
    const std::vector<std::uint32_t> colours = Viewer::cellColours(refinement, refinement.levelCount());
    const auto mesh =
        renderer.upload({topology.vertexCount(), topology.faceOffsets(), topology.vert(), colours}).value();
    const auto onPoints = renderer.uploadPoints(points).value();
    const auto onNormals = renderer.uploadPoints(normals).value();
    return renderer.draw(mesh, {onPoints.get(), 0, 3}, {onNormals.get(), 0, 3}, view).value();
  }

  const Cube cube{0};
};

TEST_F(PainterTest, DrawsFromTheComputeBuffersWhatTheCpuComputes) {
  const Far::Refinement refinement = refined(3);
  auto painter = Viewer::SurfacePainter::create(context->device(), refinement, kPainterSize);
  ASSERT_TRUE(painter) << painter.error().message;
  // Another pose before shows that each picture is of the last.
  const std::vector<float> flat(cube.points.size(), 0);
  ASSERT_TRUE(painter->pose(flat));
  ASSERT_TRUE(painter->pose(cube.points));
  const Viewer::View view = viewOf(painter->points());
  const auto picture = painter->surface(view);
  ASSERT_TRUE(picture) << picture.error().message;
  EXPECT_EQ(picture->rgba, drawnFromHost(refinement, view).rgba);
}

TEST_F(PainterTest, EveryPoseOfAPlaybackIsDrawnFromItsOwnPoints) {
  const Far::Refinement refinement = refined(2);
  auto painter = Viewer::SurfacePainter::create(context->device(), refinement, kPainterSize).value();
  const Viewer::View view = viewOf(cube.points);
  const auto scaled = [this](float factor) {
    std::vector<float> points = cube.points;
    for (float& number : points) number *= factor;
    return points;
  };
  // More poses than are in flight, drawn without a look at the points in between.
  std::vector<std::vector<std::uint8_t>> pictures;
  for (const float factor : {1.0F, 0.5F, 0.8F, 1.0F}) {
    ASSERT_TRUE(painter.pose(scaled(factor)));
    pictures.push_back(painter.surface(view).value().rgba);
  }
  EXPECT_EQ(pictures[0], pictures[3]);
  EXPECT_NE(pictures[0], pictures[1]);
  EXPECT_EQ(pictures[0], drawnFromHost(refinement, view).rgba);
}

TEST_F(PainterTest, ThereIsNothingToDrawBeforeTheFirstPose) {
  auto painter = Viewer::SurfacePainter::create(context->device(), refined(1), kPainterSize).value();
  EXPECT_TRUE(painter.points().empty());
  const auto refused = painter.surface(viewOf(cube.points));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::invalidOption);
}

TEST_F(PainterTest, CageIsLargerThanItsSurface) {
  auto painter = Viewer::SurfacePainter::create(context->device(), refined(2), kPainterSize);
  ASSERT_TRUE(painter) << painter.error().message;
  ASSERT_TRUE(painter->pose(cube.points));
  Viewer::View view = viewOf(cube.points);
  view.style.ground = false;
  const auto cage = painter->cage(view);
  const auto surface = painter->surface(view);
  ASSERT_TRUE(cage && surface);
  // The backdrop is nearly grey, cells are not.
  const auto coloured = [](const Viewer::Picture& picture) {
    int count = 0;
    for (std::int32_t y = 0; y < picture.height; ++y) {
      for (std::int32_t x = 0; x < picture.width; ++x) {
        const Pixel pixel = pixelAt(picture, x, y);
        count += std::abs(pixel.red - pixel.blue) > 24 ? 1 : 0;
      }
    }
    return count;
  };
  EXPECT_GT(coloured(*surface), 500);
  EXPECT_GT(coloured(*cage), coloured(*surface) + 200);
}

TEST_F(PainterTest, RefusesFramesOfAnotherMesh) {
  auto painter = Viewer::SurfacePainter::create(context->device(), refined(1), kPainterSize);
  ASSERT_TRUE(painter) << painter.error().message;
  const auto posed = painter->pose(std::vector<float>(21, 0));
  ASSERT_FALSE(posed);
  EXPECT_EQ(posed.error().message, "a frame of 21 numbers was given to a mesh of 8 control points");
}

}  // namespace
}  // namespace honeycomb::ViewerTests
