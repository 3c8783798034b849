#pragma once

#include <optional>
#include <span>
#include <vector>

#include "apps/gallery/model.h"
#include "apps/viewer/renderer.h"

namespace honeycomb::Gallery {

/// Pictures of one size in rows. Remembers the first failure, so that a row of pictures needs a single check at its
/// end.
class Sheet {
 public:
  /// `device` must outlive the sheet.
  Sheet(const Osd::VulkanDevice& device, Viewer::RendererOptions tile, std::int32_t columns);

  /// Pictures added from now on hold these points (x y z packed), seen along -`direction`, with that fraction of the
  /// picture to spare.
  void frame(std::span<const float> points, glm::vec3 direction, float margin = 0.03F);
  Viewer::Style& style() { return view_.style; }

  void add(const Result<Model>& model);
  /// All of them. Errors: the first one of the models, or of the renderer.
  Result<Viewer::Picture> finish() const;

 private:
  Result<Viewer::Picture> draw(const Model& model);

  Result<Viewer::Renderer> renderer_;
  float aspect_;
  std::int32_t columns_;
  Viewer::View view_;
  std::vector<Viewer::Picture> pictures_;
  std::optional<Error> error_;
};

}  // namespace honeycomb::Gallery
