#pragma once

#include "apps/cli/play/stage.h"
#include "tests/cli/workplace.h"

namespace honeycomb::Test {

/// A stage without a window, shared by the tests of a suite, and surfaces to be shown on it.
class StageTest : public Workplace {
 protected:
  static void SetUpTestSuite() { stage_ = new Cli::Play::Stage(Cli::Play::Stage::open({.picture = {64, 48}}).value()); }
  static void TearDownTestSuite() {
    delete stage_;
    stage_ = nullptr;
  }
  Cli::Play::SurfaceRequest request(const std::string& obj) const {
    Cli::Play::SurfaceRequest wanted;
    wanted.surface.input = file("mesh.obj", obj);
    return wanted;
  }
  std::shared_ptr<const Cli::Play::PlaySurface> surface(const std::string& obj) const {
    return Cli::Play::PlaySurface::build(request(obj)).value();
  }
  static Viewer::Picture picture(const std::string& backend = "tbb") {
    EXPECT_TRUE(stage_->pose(backend, 0));
    const Cli::Play::PlaySurface& shown = stage_->surface();
    return stage_->picture({}, Cli::Play::Orbit::framing(shown.outline(), shown.bounds(), 64.0F / 48)).value();
  }

  static inline Cli::Play::Stage* stage_ = nullptr;
};

}  // namespace honeycomb::Test
