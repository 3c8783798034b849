#include "apps/cli/scheme_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <charconv>

#include "apps/cli/choice.h"
#include "far/schemes/akleman.h"

namespace honeycomb::Cli {
namespace {

struct TensionChoice {
  std::string_view name;
  Far::Tension::Rule rule;
};
constexpr std::array kTensions{TensionChoice{"paper", Far::Tension::Rule::paper},
                               TensionChoice{"sqrt3", Far::Tension::Rule::sqrt3},
                               TensionChoice{"topmod", Far::Tension::Rule::topmod}};

struct BoundaryChoice {
  std::string_view name;
  Far::BoundaryRule rule;
};
constexpr std::array kBoundaries{BoundaryChoice{"brick", Far::BoundaryRule::brick},
                                 BoundaryChoice{"eq16", Far::BoundaryRule::eq16},
                                 BoundaryChoice{"drop", Far::BoundaryRule::drop}};

struct CornerChoice {
  std::string_view name;
  bool keep;
};
constexpr std::array kCorners{CornerChoice{"none", false}, CornerChoice{"valence2", true}};

Result<Far::Tension> parseTension(const std::string& text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc() && end == text.data() + text.size())
    return Far::Tension{Far::Tension::Rule::constant, number};
  const auto named = choose(kTensions, "--tension", text);
  if (!named) return fail(ErrorCode::invalidOption, named.error().message + ", or give a number between 0 and 1");
  return Far::Tension{(*named)->rule};
}

Result<Far::Scheme> makeAkleman(const SchemeOptions& options) {
  const Result<Far::Tension> tension = parseTension(options.tension);
  if (!tension) return tl::unexpected(tension.error());
  const auto boundary = choose(kBoundaries, "--boundary", options.boundary);
  if (!boundary) return tl::unexpected(boundary.error());
  Far::AklemanOptions akleman;
  akleman.tension = *tension;
  akleman.edgeParameter = options.edgeParameter;
  akleman.boundary = (*boundary)->rule;
  akleman.boundaryWeight = options.boundaryWeight.value_or(akleman.boundaryWeight);
  return Far::akleman(akleman);
}

constexpr std::array kSchemes{SchemeEntry{"akleman", makeAkleman}};

}  // namespace

std::span<const SchemeEntry> schemes() {
  return kSchemes;
}

void addSchemeOptions(CLI::App& subcommand, SchemeOptions& options) {
  subcommand.add_option("--scheme", options.scheme, "Subdivision scheme: " + names(kSchemes))->capture_default_str();
  subcommand
      .add_option("--tension", options.tension,
                  "Weight a corner point keeps on its corner: " + names(kTensions) + ", or a number in (0, 1)")
      ->capture_default_str();
  subcommand
      .add_option("--edge-parameter", options.edgeParameter, "Where a corner point sits along its edge, in [0, 1]")
      ->capture_default_str();
  subcommand.add_option("--boundary", options.boundary, "Boundary rule: " + names(kBoundaries))->capture_default_str();
  subcommand.add_option("--sn", options.boundaryWeight,
                        "Weight of the neighbours in an eq16 boundary point, in [0, 1] [0.25]");
  subcommand
      .add_option("--corners", options.corners,
                  "Boundary vertices that stay where they are (brick): " + names(kCorners))
      ->capture_default_str();
}

Result<Far::Scheme> makeScheme(const SchemeOptions& options) {
  const auto scheme = choose(kSchemes, "--scheme", options.scheme);
  if (!scheme) return tl::unexpected(scheme.error());
  const auto corners = choose(kCorners, "--corners", options.corners);
  if (!corners) return tl::unexpected(corners.error());
  if ((*corners)->keep && options.boundary != "brick")
    return fail(ErrorCode::invalidOption, fmt::format("--corners {}: only the brick boundary keeps corners; leave out "
                                                      "--boundary {}",
                                                      options.corners, options.boundary));
  if (options.boundaryWeight && options.boundary != "eq16")
    return fail(
        ErrorCode::invalidOption,
        fmt::format("--sn {}: only the eq16 boundary has this weight; add --boundary eq16", *options.boundaryWeight));
  return (*scheme)->make(options);
}

bool keepsCorners(const SchemeOptions& options) {
  const auto corners = choose(kCorners, "--corners", options.corners);
  return corners && (*corners)->keep;
}

}  // namespace honeycomb::Cli
