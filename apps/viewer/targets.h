#pragma once

#include "apps/viewer/gpu.h"
#include "apps/viewer/pipelines.h"

namespace honeycomb::Viewer {

/// The images a renderer draws into, and the buffer it reads the picture from.
struct Targets {
  Image shadowMaps;  ///< kTilesAcross x kTilesAcross tiles
  Owned<VkFramebuffer> shadowFrame;
  Owned<VkSampler> shadowSampler;
  Image colour;
  Image depth;
  Image resolved;
  Owned<VkFramebuffer> pictureFrame;
  Buffer pixels;  ///< 4 bytes a pixel, rows from the top
};

Targets makeTargets(Maker& make, const Gpu& gpu, const Pipelines& pipelines, const PictureFormats& formats,
                    VkExtent2D extent);

/// The first format the device can draw multisampled depth in.
VkFormat pickDepthFormat(const Gpu& gpu);

}  // namespace honeycomb::Viewer
