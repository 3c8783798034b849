#pragma once

#include <filesystem>
#include <string>

#include "far/base/result.h"

namespace honeycomb::Io {

/// The extension with its dot, in lower case.
std::string lowerExtension(const std::filesystem::path& path);

/// Is the file there, one of the formats in their table, not larger than Assimp can take, and does it begin as its
/// format does? What is none of these never reaches Assimp. Errors: unreadable, invalidFile, tooLarge.
Result<void> checkSceneFile(const std::filesystem::path& path);

}  // namespace honeycomb::Io
