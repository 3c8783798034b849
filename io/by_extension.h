#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "far/base/result.h"
#include "io/scene/scene_format.h"

namespace honeycomb::Io {

/// The entry of a table of formats whose `name` is the path's extension, in upper or lower case. `kind` says what all
/// of them are ("written meshes"). Errors: invalidOption, listing the extensions.
template <class Table>
auto byExtension(const Table& table, std::string_view kind, const std::filesystem::path& path)
    -> Result<decltype(&table[0])> {
  const std::string extension = lowerExtension(path);
  std::string all;
  for (const auto& format : table) {
    if (format.name == extension) return &format;
    all += (all.empty() ? "" : ", ") + std::string(format.name);
  }
  return fail(ErrorCode::invalidOption,
              fmt::format("{}: {} end in {}; give a file of that kind", path.string(), kind, all));
}

}  // namespace honeycomb::Io
