#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "far/base/result.h"

namespace honeycomb::Io {

/// Points without a mesh: the `v` statements of a Wavefront OBJ.
struct ObjPoints {
  std::vector<double> positions;    ///< x y z per point
  std::vector<std::int64_t> lines;  ///< 1-based line of each

  std::int64_t count() const { return static_cast<std::int64_t>(lines.size()); }
};

/// Reads the `v` statements of an OBJ file and passes over all others, faces too. A weight or a colour behind x y z is
/// passed over. Linear in the file's size. Errors: unreadable; invalidFile with the message "FILE:LINE: what and what
/// to do" and the line as element, for numbers that can't be read, and "FILE: ..." for binary data or no points;
/// invalidPositions (element: the point, counted from 0) for NaN or infinity.
Result<ObjPoints> readObjPoints(const std::filesystem::path& path);

/// The same from a text in memory; `name` stands for the file in messages.
Result<ObjPoints> parseObjPoints(std::string_view text, std::string_view name);

}  // namespace honeycomb::Io
