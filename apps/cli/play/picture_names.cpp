#include "apps/cli/play/picture_names.h"

#include <regex>

namespace honeycomb::Cli::Play {

std::optional<PictureNames> PictureNames::parse(const std::filesystem::path& path) {
  static const std::regex kPattern("([^%]*)%(?:0([1-9]|1[0-8]))?d([^%]*)");
  const std::string name = path.filename().string();
  std::smatch parts;
  if (!std::regex_match(name, parts, kPattern)) return std::nullopt;
  PictureNames names;
  names.folder_ = path.parent_path();
  names.before_ = parts[1];
  names.after_ = parts[3];
  if (parts[2].matched) names.width_ = std::stoul(parts[2]);
  return names;
}

std::filesystem::path PictureNames::operator()(std::int64_t number) const {
  std::string digits = std::to_string(number);
  if (digits.size() < width_) digits.insert(0, width_ - digits.size(), '0');
  return folder_ / (before_ + digits + after_);
}

}  // namespace honeycomb::Cli::Play
