#pragma once

#include <string>

#include "apps/cli/play/surface.h"

namespace honeycomb::Cli::Play {

/// Refines a frame once on a second Vulkan device of that name. Mesa's lavapipe compiles a kernel when it first runs,
/// on the thread of the queue, where pictures would wait behind it for seconds; afterwards its code is in the driver's
/// cache, from which every other device has it in milliseconds. Returns when that is done. What fails here is met
/// again, with its error, on the device that is drawn with.
void rehearse(const std::string& device, const PlaySurface& surface);

}  // namespace honeycomb::Cli::Play
