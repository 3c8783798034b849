#pragma once

#include <string>

namespace honeycomb::Cli {

/// What the system calls the processor.
std::string processorName();

/// Processor, memory, Vulkan devices, and what this build can do.
std::string machineText();
std::string machineJson();

}  // namespace honeycomb::Cli
