#include "far/schemes/akleman.h"

#include <array>

#include "chain/choice.h"
#include "chain/schemes.h"

namespace honeycomb::Chain {
namespace {

constexpr SchemeOption kTension{
    "--tension", SchemeOption::Kind::text, "paper",
    "Weight a corner point keeps on its corner: paper, sqrt3, topmod, or a number in (0, 1)"};
constexpr SchemeOption kEdgeParameter{"--edge-parameter", SchemeOption::Kind::number, "0.5",
                                      "Where a corner point sits along its edge, in [0, 1]"};

struct TensionChoice {
  std::string_view name;
  Far::Tension::Rule rule;
};
constexpr std::array kTensions{TensionChoice{"paper", Far::Tension::Rule::paper},
                               TensionChoice{"sqrt3", Far::Tension::Rule::sqrt3},
                               TensionChoice{"topmod", Far::Tension::Rule::topmod}};

Result<Far::Tension> parseTension(const std::string& text) {
  if (const auto number = parseNumber(text)) return Far::Tension{Far::Tension::Rule::constant, *number};
  const auto named = choose(kTensions, kTension.name, text);
  if (!named) return fail(ErrorCode::invalidOption, named.error().message + ", or give a number between 0 and 1");
  return Far::Tension{(*named)->rule};
}

Result<std::vector<Far::Scheme>> make(const SchemeRequest& request) {
  const Result<Far::Tension> tension = parseTension(request.options.text(kTension));
  if (!tension) return tl::unexpected(tension.error());
  Far::AklemanOptions akleman;
  akleman.tension = *tension;
  akleman.edgeParameter = request.options.number(kEdgeParameter).value_or(akleman.edgeParameter);
  akleman.boundary = zipBoundary(request.boundary);
  akleman.boundaryWeight = request.options.number(kBoundaryWeightOption).value_or(akleman.boundaryWeight);
  return Far::akleman(akleman).map(
      [&](const Far::Scheme& step) { return std::vector(static_cast<std::size_t>(request.levels), step); });
}

constexpr std::array kOptions{&kTension, &kEdgeParameter, &kBoundaryOption, &kBoundaryWeightOption, &kCornersOption};
constexpr std::array<std::string_view, 3> kBoundaries{"brick", "eq16", "drop"};

}  // namespace

const SchemeEntry kAkleman{"akleman", make, kOptions, kBoundaries};

}  // namespace honeycomb::Chain
