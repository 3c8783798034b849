#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "apps/cli/play/orbit.h"
#include "apps/cli/play/surface.h"
#include "apps/viewer/look.h"
#include "apps/viewer/poses.h"
#include "apps/viewer/renderer.h"
#include "osd/vulkan/context.h"
#include "osd/vulkan/evaluator.h"

namespace honeycomb::Cli::Play {

/// The backend that refines on the device that draws.
constexpr std::string_view kDeviceBackend = "vulkan";

/// How a surface is shown.
struct Appearance {
  std::size_t look = 0;       ///< of Viewer::looks()
  std::optional<bool> edges;  ///< none: as the look has them
  bool cage = false;
  bool normals = false;
};

struct StageOptions {
  Osd::VulkanContextOptions context{};
  Viewer::RendererOptions picture{};
};

/// What a surface is brought to a device for.
struct LoadOptions {
  std::vector<std::string> backends;  ///< that its frames will be refined on
  Viewer::Colouring colouring = Viewer::Colouring::plain;
};

/// A surface on a device, to be shown.
struct LoadedSurface {
  std::shared_ptr<const PlaySurface> surface;
  Viewer::CellMesh cells;
  Viewer::LineMesh cage;
  Viewer::Colouring colouring = Viewer::Colouring::plain;
  std::map<std::string, std::unique_ptr<Viewer::Poses>> poses;  ///< by backend; they refer to the surface
};

/// A device and what is on it: a surface, what refines it, and the renderer. Belongs to one thread at a time.
class Stage {
 public:
  /// Errors: noDevice where there is none that draws; those of Renderer::create.
  static Result<Stage> open(const StageOptions& options);
  Stage(Stage&&) noexcept;
  Stage& operator=(Stage&&) noexcept;
  ~Stage();

  /// Brings a surface to the device, beside the one that is shown, and prepares the backends; what can't be is left
  /// out, and its error met where it is used. Thread-safe: the stage may be drawing, but neither be moved nor end.
  /// Errors: outOfMemory, tooLarge, deviceLost.
  Result<LoadedSurface> load(const std::shared_ptr<const PlaySurface>& surface, const LoadOptions& options) const;
  /// Shows a surface that this stage has loaded, in place of the one before; nothing may still draw that.
  void show(LoadedSurface loaded);
  /// Both. After an error the one before stays. Errors: those of load.
  Result<void> show(const std::shared_ptr<const PlaySurface>& surface);
  const PlaySurface& surface() const { return *shown_.surface; }
  const std::shared_ptr<const PlaySurface>& shared() const { return shown_.surface; }
  Viewer::Colouring colouring() const { return shown_.colouring; }

  /// Brings the tables of a surface to where that backend needs them, and has compiled what it runs. Thread-safe as
  /// load(). Errors: invalidOption for an unknown backend; outOfMemory, tooLarge, unsupported, deviceLost.
  Result<std::unique_ptr<Viewer::Poses>> prepare(const std::string& backend, const PlaySurface& surface) const;
  /// Keeps what prepare() made for the surface that is shown.
  void add(const std::string& backend, std::unique_ptr<Viewer::Poses> poses);
  /// Would pose() have nothing to bring?
  bool refinesBy(const std::string& backend) const { return shown_.poses.contains(backend); }
  /// A backend that is ready so; empty where none is.
  std::string readyBackend() const { return shown_.poses.empty() ? std::string() : shown_.poses.begin()->first; }

  /// Refines a frame on that backend (vulkan, or one of backends()), whose tables are brought where they are needed
  /// when first asked for, and makes it the pose that is drawn. Errors: those of the animation, naming the frame;
  /// deviceLost.
  Result<Viewer::PoseTimes> pose(const std::string& backend, std::int32_t frame);
  /// Refined points of the last pose, x y z packed.
  std::span<const float> refined() const { return posed_ ? posed_->refined() : std::span<const float>(); }

  /// What to draw, and how, once there is a pose. The appearance's colours are brought to the device: nothing may still
  /// be drawn. Errors: invalidOption before the first pose.
  Result<Viewer::Subject> subject(const Appearance& appearance);
  Viewer::View view(const Appearance& appearance, const Orbit& orbit) const;
  /// Both, drawn and read back.
  Result<Viewer::Picture> picture(const Appearance& appearance, const Orbit& orbit);

  Viewer::Renderer& renderer() { return renderer_; }
  const Osd::VulkanContext& context() const { return *context_; }

 private:
  Stage(std::unique_ptr<Osd::VulkanContext> context, Result<Osd::VulkanEvaluator> evaluator, Viewer::Renderer renderer);
  Result<std::unique_ptr<Viewer::Poses>> makePoses(const std::string& backend, const PlaySurface& surface) const;
  Result<Viewer::Poses*> poses(const std::string& backend);
  void recolour(Viewer::Colouring wanted);

  std::unique_ptr<Osd::VulkanContext> context_;
  Result<Osd::VulkanEvaluator> evaluator_;  ///< of all surfaces: kernels are compiled once
  Viewer::Renderer renderer_;
  LoadedSurface shown_;
  Viewer::Poses* posed_ = nullptr;
  FrameStorage storage_;
};

/// The look of that name. Errors: invalidOption, listing what there is.
Result<std::size_t> lookNamed(std::string_view name);

}  // namespace honeycomb::Cli::Play
