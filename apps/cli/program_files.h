#pragma once

#include <filesystem>
#include <string_view>

namespace honeycomb::Cli {

/// Files that come with the program are found from where it lies, so that an installation can be moved.

/// A module that is loaded when it is needed: beside the program where it was built, in lib/honeycomb where it is
/// installed.
std::filesystem::path moduleFile(std::string_view name);
/// A mesh of the project's: in share/honeycomb where the program is installed, else in the project's folder.
std::filesystem::path assetFile(std::string_view name);

}  // namespace honeycomb::Cli
