#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace honeycomb::Cli::Play {

/// The names of numbered pictures: "frame_%04d.png" is frame_0000.png, frame_0001.png, ...
class PictureNames {
 public:
  /// A path whose file name has one %d or %0Nd, N from 1 to 18; nothing for any other.
  static std::optional<PictureNames> parse(const std::filesystem::path& path);
  std::filesystem::path operator()(std::int64_t number) const;

 private:
  std::filesystem::path folder_;
  std::string before_, after_;
  std::size_t width_ = 0;
};

}  // namespace honeycomb::Cli::Play
