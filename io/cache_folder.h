#pragma once

#include <filesystem>

namespace honeycomb::Io {

/// The user's folder for what honeycomb can make again: $XDG_CACHE_HOME/honeycomb, else ~/.cache/honeycomb, else empty.
/// It need not exist. As the XDG base directory specification says, a relative $XDG_CACHE_HOME counts as none.
std::filesystem::path cacheFolder();

}  // namespace honeycomb::Io
