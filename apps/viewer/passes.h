#pragma once

#include "apps/viewer/pipelines.h"

namespace honeycomb::Viewer {

/// Depth only, kept for sampling by fragment shaders.
Owned<VkRenderPass> makeShadowPass(Maker& make, const Gpu& gpu);

/// Multisampled colour and depth, resolved into an image that is then copied from.
Owned<VkRenderPass> makePicturePass(Maker& make, const Gpu& gpu, const PictureFormats& formats);

}  // namespace honeycomb::Viewer
