#pragma once

#include <string>
#include <vector>

namespace honeycomb::Test {

/// Drags files onto the window that takes them, on the X server of DISPLAY, and drops them there, as a file manager
/// does: by the messages of XDND 5 (freedesktop.org's Drag-and-Drop Protocol for the X Window System). False where no
/// window takes any or it doesn't answer within ten seconds.
bool dropFiles(const std::vector<std::string>& paths);

}  // namespace honeycomb::Test
