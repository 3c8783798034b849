#pragma once

#include "apps/demo/vulkan_part.h"
#include "osd/vulkan/core.h"

namespace honeycomb::Demo {

/// Writes frame_NNN.png for some frames, each from a side of its own, and sheet.png: the control mesh beside its
/// levels of refinement, and below them frames from a camera that stays put.
Result<std::vector<std::filesystem::path>> paintPictures(const Osd::VulkanDevice& device,
                                                         const Osd::VulkanEvaluatorOptions& evaluation,
                                                         const Animation& animation, const Far::Topology& control,
                                                         const Far::Scheme& scheme, const PictureOptions& options);

}  // namespace honeycomb::Demo
