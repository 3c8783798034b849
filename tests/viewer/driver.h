#pragma once

namespace honeycomb::ViewerTests {

/// Keeps the Vulkan driver loaded until the process ends. Mesa's software rasteriser leaves a few blocks behind with
/// every pipeline it compiles; the leak checker passes them over by the driver's name, which it only knows while the
/// driver is loaded. Objects of ours that aren't destroyed are still reported.
void keepDriverLoaded();

}  // namespace honeycomb::ViewerTests
