#pragma once

#include <span>

#include "apps/viewer/picture.h"
#include "far/base/result.h"
#include "osd/vulkan/device.h"

namespace honeycomb::Gallery {

/// One picture of the gallery.
struct Plate {
  const char* name;  ///< of its file, without the ending
  const char* title;
  const char* caption;  ///< Markdown: paper and figure, what is to be seen, in the order of the tiles
  Result<Viewer::Picture> (*draw)(const Osd::VulkanDevice& device);
};

/// Figures of E. Akleman, V. Srinivasan, "Honeycomb Subdivision".
std::span<const Plate> aklemanPlates();
/// Figures of Zhang H.-X., Wang G.-J., "Honeycomb Subdivision".
std::span<const Plate> zhangWangPlates();
/// Figures of P. Barendrecht, M. Sabin, J. Kosinka, "A bivariate C1 subdivision scheme based on cubic half-box
/// splines", those in the plane and those in space.
std::span<const Plate> configurationPlates();
std::span<const Plate> halfBoxPlates();
/// Of D. Finn, "Simple Subdivision Methods", and all schemes side by side.
std::span<const Plate> finnPlates();
/// Texture coordinates with seams; not from a paper.
std::span<const Plate> texturedPlates();

}  // namespace honeycomb::Gallery
