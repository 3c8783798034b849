#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "far/base/result.h"
#include "io/frame_layout.h"
#include "io/frame_source.h"

namespace honeycomb::Io {

/// A kind of point cache: the points of a deforming mesh, frame by frame, and nothing else of it. A new one is one line
/// of the table in point_cache.cpp.
struct PointCache {
  std::string_view name;  ///< the extension with its dot, in lower case
  /// Errors: those of the format's reader.
  Result<std::shared_ptr<const FrameSource>> (*open)(const std::filesystem::path&);
  /// A cache to be written, whose times `info` has in frames, `framesPerSecond` of them a second; `name` stands for the
  /// file in messages. Errors: those of the format.
  Result<std::shared_ptr<const FrameLayout>> (*layout)(std::string_view name, const FrameInfo& info,
                                                       double framesPerSecond);
};

/// The kind of a point cache by its path's extension, in upper or lower case. Errors: invalidOption, listing them.
Result<const PointCache*> pointCache(const std::filesystem::path& path);

}  // namespace honeycomb::Io
