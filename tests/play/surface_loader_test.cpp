#include "apps/cli/play/surface_loader.h"

#include <future>

#include "tests/play/stage_fixture.h"

namespace honeycomb::Test {
namespace {

using namespace Cli::Play;

class SurfaceLoaderTest : public StageTest {
 protected:
  SurfaceLoader loader_;
};

TEST_F(SurfaceLoaderTest, WhatAnotherThreadHasLoadedIsThePictureOfShowingIt) {
  ASSERT_TRUE(stage_->show(surface(torusObj(4))));
  const Viewer::Picture torus = picture();
  const SurfaceRequest cube = request(cubeObj());
  ASSERT_TRUE(stage_->show(PlaySurface::build(cube).value()));
  const Viewer::Picture expected = picture();
  ASSERT_NE(torus.rgba, expected.rgba);

  ASSERT_TRUE(stage_->show(surface(torusObj(4))));
  loader_.useStage(stage_);
  loader_.expect({{"tbb"}, Viewer::Colouring::plain});
  (void)request(cubeObj());
  auto building = std::async(std::launch::async, [&] { return loader_.build(cube).value(); });
  // What is shown is drawn meanwhile.
  EXPECT_EQ(picture().rgba, torus.rgba);
  const auto surface = building.get();
  auto loaded = loader_.take(*surface);
  ASSERT_TRUE(loaded);
  EXPECT_TRUE(loaded->poses.contains("tbb")) << "and what refines it";
  stage_->show(std::move(*loaded));
  EXPECT_EQ(picture().rgba, expected.rgba);
  EXPECT_FALSE(loader_.take(*surface)) << "once";
}

TEST_F(SurfaceLoaderTest, TablesForTheDeviceComeWithTheSurface) {
  ASSERT_TRUE(stage_->show(surface(torusObj(4))));
  const Viewer::Picture torus = picture();
  const SurfaceRequest cube = request(cubeObj());
  loader_.useStage(stage_);
  loader_.expect({{"vulkan"}, Viewer::Colouring::plain});
  auto building = std::async(std::launch::async, [&] { return loader_.build(cube).value(); });
  EXPECT_EQ(picture().rgba, torus.rgba) << "meanwhile";
  auto loaded = loader_.take(*building.get());
  ASSERT_TRUE(loaded);
  stage_->show(std::move(*loaded));
  EXPECT_TRUE(stage_->refinesBy("vulkan")) << "nothing is left to do for the thread that draws";
  EXPECT_EQ(picture("vulkan").rgba, picture("tbb").rgba);
}

TEST_F(SurfaceLoaderTest, WithoutAStageSurfacesAreBuiltAlone) {
  loader_.useStage(stage_);
  loader_.useStage(nullptr);
  const auto surface = loader_.build(request(cubeObj())).value();
  EXPECT_FALSE(loader_.take(*surface));
}

TEST_F(SurfaceLoaderTest, OfAStageThatGoesNothingIsLeft) {
  loader_.useStage(stage_);
  const auto surface = loader_.build(request(cubeObj())).value();
  loader_.useStage(nullptr);
  EXPECT_FALSE(loader_.take(*surface));
}

TEST_F(SurfaceLoaderTest, OnlyTheLastSurfaceIsKept) {
  loader_.useStage(stage_);
  const auto first = loader_.build(request(cubeObj())).value();
  const auto second = loader_.build(request(torusObj(4))).value();
  EXPECT_FALSE(loader_.take(*first));
  EXPECT_TRUE(loader_.take(*second));
}

TEST_F(SurfaceLoaderTest, ErrorsOfBuildingAreItsOwn) {
  loader_.useStage(stage_);
  SurfaceRequest wanted;
  wanted.surface.input = path("missing.obj");
  EXPECT_EQ(loader_.build(wanted).error().code, ErrorCode::unreadable);
}

}  // namespace
}  // namespace honeycomb::Test
