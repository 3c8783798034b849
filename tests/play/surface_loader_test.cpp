#include "apps/cli/play/surface_loader.h"

#include <future>

#include "tests/cli/workplace.h"

namespace honeycomb::Test {
namespace {

using namespace Cli::Play;

class SurfaceLoaderTest : public Workplace {
 protected:
  static void SetUpTestSuite() { stage_ = new Stage(Stage::open({.picture = {64, 48}}).value()); }
  static void TearDownTestSuite() {
    delete stage_;
    stage_ = nullptr;
  }
  SurfaceRequest request(const std::string& obj) const {
    SurfaceRequest wanted;
    wanted.surface.input = file("mesh.obj", obj);
    return wanted;
  }
  static Viewer::Picture picture(const PlaySurface& surface) {
    EXPECT_TRUE(stage_->pose("tbb", 0));
    return stage_->picture({}, Orbit::framing(surface.outline(), surface.bounds(), 64.0F / 48)).value();
  }

  static Stage* stage_;
  SurfaceLoader loader_;
};
Stage* SurfaceLoaderTest::stage_ = nullptr;

TEST_F(SurfaceLoaderTest, WhatAnotherThreadHasLoadedIsThePictureOfShowingIt) {
  ASSERT_TRUE(stage_->show(PlaySurface::build(request(torusObj(4))).value()));
  const Viewer::Picture torus = picture(stage_->surface());
  const SurfaceRequest cube = request(cubeObj());
  ASSERT_TRUE(stage_->show(PlaySurface::build(cube).value()));
  const Viewer::Picture expected = picture(stage_->surface());
  ASSERT_NE(torus.rgba, expected.rgba);

  ASSERT_TRUE(stage_->show(PlaySurface::build(request(torusObj(4))).value()));
  loader_.useStage(stage_);
  loader_.expect({{"tbb"}, Viewer::Colouring::plain});
  (void)request(cubeObj());
  auto building = std::async(std::launch::async, [&] { return loader_.build(cube).value(); });
  // What is shown is drawn meanwhile.
  EXPECT_EQ(picture(stage_->surface()).rgba, torus.rgba);
  const auto surface = building.get();
  auto loaded = loader_.take(*surface);
  ASSERT_TRUE(loaded);
  EXPECT_TRUE(loaded->poses.contains("tbb")) << "and what refines it";
  stage_->show(std::move(*loaded));
  EXPECT_EQ(picture(*surface).rgba, expected.rgba);
  EXPECT_FALSE(loader_.take(*surface)) << "once";
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
