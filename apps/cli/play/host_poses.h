#pragma once

#include <memory>
#include <string_view>

#include "apps/cli/play/surface.h"
#include "apps/cli/surface_evaluator.h"
#include "apps/viewer/poses.h"
#include "apps/viewer/renderer.h"

namespace honeycomb::Cli::Play {

/// Refined by a backend on the CPU and brought to the device.
class HostPoses : public Viewer::Poses {
 public:
  /// The surface and the renderer's device outlive this. Errors: invalidOption for an unknown backend; outOfMemory.
  static Result<HostPoses> create(std::string_view backend, const PlaySurface& surface,
                                  const Viewer::Renderer& renderer);

  Result<Viewer::PoseTimes> pose(std::span<const float> control) override;
  Result<Viewer::PosedPoints> points() const override;
  std::span<const float> refined() const override;

 private:
  HostPoses() = default;

  std::unique_ptr<Backend> backend_;
  std::unique_ptr<SurfaceEvaluator> evaluator_;
  Surface<float> surface_;
  Viewer::Buffer control_, refined_, normals_;
  bool posed_ = false;
};

}  // namespace honeycomb::Cli::Play
