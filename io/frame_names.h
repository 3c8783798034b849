#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace honeycomb::Io {

/// The names of a sequence of files, one a frame: "out_%04d.obj" is out_0000.obj, out_0001.obj, ...
class FrameNames {
 public:
  /// A path whose file name has one "%d", "%4d" or "%04d" (any width up to 18; both pad with zeros): nothing for any
  /// other, so that a name with a percent sign is a name.
  static std::optional<FrameNames> parse(const std::filesystem::path& path);

  /// The path of a frame, folder and all.
  std::filesystem::path operator()(std::int64_t frame) const { return folder_ / name(frame); }
  /// Without the folder.
  std::string name(std::int64_t frame) const;
  /// The frame whose name this is, without a folder; nothing, where it is none's.
  std::optional<std::int64_t> frameOf(const std::string& name) const;

 private:
  FrameNames(std::filesystem::path folder, std::string before, std::string after, int width)
      : folder_(std::move(folder)), before_(std::move(before)), after_(std::move(after)), width_(width) {}

  std::filesystem::path folder_;
  std::string before_, after_;
  int width_ = 0;
};

}  // namespace honeycomb::Io
