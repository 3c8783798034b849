#include "apps/cli/play/options.h"

#include <fmt/format.h>

#include <charconv>

namespace honeycomb::Cli::Play {
namespace {

/// The whole text as a whole number from 1 on.
std::optional<std::int32_t> parseSide(std::string_view text) {
  std::int32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number < 1) return std::nullopt;
  return number;
}

}  // namespace

Result<PictureSize> parseSize(const std::string& text) {
  if (text.empty()) return PictureSize{};
  const std::size_t cross = text.find('x');
  if (cross != std::string::npos) {
    const auto width = parseSide(std::string_view(text).substr(0, cross));
    const auto height = parseSide(std::string_view(text).substr(cross + 1));
    if (width && height) return PictureSize{*width, *height};
  }
  return fail(ErrorCode::invalidOption, fmt::format("--size {}: give width and height in pixels, as 1280x800", text));
}

Result<PlaySettings> settingsOf(const PlayCommand& command) {
  const auto look = lookNamed(command.view);
  if (!look) return tl::unexpected(look.error());
  const auto size = parseSize(command.size);
  if (!size) return tl::unexpected(size.error());
  auto backend = BackendChoice::parse(command.request.surface.backend);
  if (!backend) return tl::unexpected(backend.error());
  Appearance appearance{*look, std::nullopt, command.cage, command.normals};
  if (command.edges || command.noEdges) appearance.edges = command.edges;
  return PlaySettings{appearance, *size, std::move(*backend)};
}

}  // namespace honeycomb::Cli::Play
