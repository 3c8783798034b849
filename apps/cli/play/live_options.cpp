#include "apps/cli/play/live_options.h"

#include <fmt/format.h>

#include <algorithm>

namespace honeycomb::Cli::Play {
namespace {

constexpr double kOptionStep = 0.05;
constexpr double kFirstNumber = 0.5;  ///< of an option that was no number before

std::vector<const SchemeEntry*> entriesOf(const std::string& scheme) {
  SchemeOptions alone;
  alone.scheme = scheme;
  std::vector<const SchemeEntry*> entries;
  if (const auto chain = readChain(alone, std::nullopt))
    for (const ChainPart& part : chain->parts) entries.push_back(part.scheme);
  return entries;
}

void addNew(const SchemeOption* option, std::vector<const SchemeOption*>& options) {
  const auto same = [&](const SchemeOption* other) { return other->name == option->name; };
  if (std::none_of(options.begin(), options.end(), same)) options.push_back(option);
}

template <class Container>
std::size_t placeOf(const Container& container, const std::string& value) {
  const auto found = std::find(container.begin(), container.end(), value);
  return found == container.end() ? 0 : static_cast<std::size_t>(found - container.begin());
}

std::size_t stepped(std::size_t place, int direction, std::size_t count) {
  return (place + count + static_cast<std::size_t>(direction > 0 ? 1 : count - 1)) % count;
}

}  // namespace

std::vector<const SchemeOption*> optionsOf(const SurfaceRequest& request) {
  std::vector<const SchemeOption*> options;
  for (const SchemeEntry* entry : entriesOf(request.surface.scheme.scheme))
    for (const SchemeOption* option : entry->options) addNew(option, options);
  return options;
}

std::int32_t levelsOf(const SurfaceRequest& request) {
  const auto chain = readChain(request.surface.scheme, request.surface.levels);
  return chain ? chain->levels : request.surface.levels.value_or(LevelChoice{}.usual);
}

void setScheme(SurfaceRequest& request, const std::string& scheme) {
  SchemeOptions& options = request.surface.scheme;
  const std::int32_t levels = levelsOf(request);
  const std::vector<const SchemeOption*> before = optionsOf(request);
  options.scheme = scheme;
  // A chain has its levels in itself.
  if (scheme.find(':') == std::string::npos)
    request.surface.levels = levels;
  else
    request.surface.levels.reset();
  const std::vector<const SchemeOption*> now = optionsOf(request);
  for (const SchemeOption* option : before) {
    const auto same = [&](const SchemeOption* other) { return other->name == option->name; };
    const std::vector<std::string> choices = choicesOf(request, *option);
    const bool fits = choices.empty() || std::count(choices.begin(), choices.end(), options.text(*option)) > 0;
    if (std::none_of(now.begin(), now.end(), same) || !fits) options.reset(*option);
  }
}

void setLevels(SurfaceRequest& request, std::int32_t levels) {
  request.surface.levels = levels;
}

void stepScheme(SurfaceRequest& request, const std::string& from, int direction) {
  std::vector<std::string> names;
  for (const SchemeEntry& entry : schemes()) names.emplace_back(entry.name);
  setScheme(request, names[stepped(placeOf(names, from), direction, names.size())]);
}

std::vector<std::string> choicesOf(const SurfaceRequest& request, const SchemeOption& option) {
  if (option.name == kCornersOption.name) return {"none", "valence2"};
  if (option.name == kBoundaryOption.name) {
    const auto entries = entriesOf(request.surface.scheme.scheme);
    if (entries.empty()) return {};
    return {entries.front()->boundaries.begin(), entries.front()->boundaries.end()};
  }
  return {};
}

void stepOption(SurfaceRequest& request, const SchemeOption& option, int direction) {
  SchemeOptions& options = request.surface.scheme;
  if (option.kind == SchemeOption::Kind::flag) {
    if (options.given(option))
      options.reset(option);
    else
      options.set(option, "true");
    return;
  }
  const std::vector<std::string> choices = choicesOf(request, option);
  if (!choices.empty()) {
    options.set(option, choices[stepped(placeOf(choices, options.text(option)), direction, choices.size())]);
    return;
  }
  const std::string before = options.text(option);
  const std::optional<double> number = parseNumber(before);
  const double next = number ? *number + direction * kOptionStep : kFirstNumber;
  options.set(option, fmt::format("{:.4g}", next));
}

}  // namespace honeycomb::Cli::Play
