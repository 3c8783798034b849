#include "io/cache_folder.h"

#include <cstdlib>

namespace honeycomb::Io {

namespace {

/// The absolute path a variable of the environment holds; empty: none.
std::filesystem::path folderIn(const char* variable) {
  const char* const value = std::getenv(variable);
  const std::filesystem::path folder(value == nullptr ? "" : value);
  return folder.is_absolute() ? folder : std::filesystem::path();
}

}  // namespace

std::filesystem::path cacheFolder() {
  if (const auto cache = folderIn("XDG_CACHE_HOME"); !cache.empty()) return cache / "honeycomb";
  if (const auto home = folderIn("HOME"); !home.empty()) return home / ".cache" / "honeycomb";
  return {};
}

}  // namespace honeycomb::Io
