#include "io/frame_names.h"

#include <fmt/format.h>

#include <charconv>
#include <string_view>

namespace honeycomb::Io {
namespace {

constexpr int kMostDigits = 18;  // of 64 bits

}  // namespace

std::optional<FrameNames> FrameNames::parse(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  const std::size_t percent = name.find('%');
  if (percent == std::string::npos || name.find('%', percent + 1) != std::string::npos) return std::nullopt;
  int width = 0;
  const char* end = name.data() + percent + 1;
  if (name[percent + 1] != 'd') {
    const auto [rest, error] = std::from_chars(end, name.data() + name.size(), width);
    if (error != std::errc() || width < 0 || width > kMostDigits) return std::nullopt;
    end = rest;
  }
  if (end == name.data() + name.size() || *end != 'd') return std::nullopt;
  return FrameNames(path.parent_path(), name.substr(0, percent), end + 1, width);
}

std::string FrameNames::name(std::int64_t frame) const {
  return fmt::format("{}{:0{}}{}", before_, frame, width_, after_);
}

std::optional<std::int64_t> FrameNames::frameOf(const std::string& name) const {
  if (name.size() <= before_.size() + after_.size()) return std::nullopt;
  const char* end = name.data() + name.size() - after_.size();
  std::int64_t frame = 0;
  if (std::from_chars(name.data() + before_.size(), end, frame).ptr != end || frame < 0) return std::nullopt;
  return this->name(frame) == name ? std::optional(frame) : std::nullopt;
}

}  // namespace honeycomb::Io
