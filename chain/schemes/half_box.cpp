#include "far/schemes/half_box.h"

#include <array>

#include "chain/choice.h"
#include "chain/schemes.h"

namespace honeycomb::Chain {

const SchemeOption kTunedOption{"--tuned", SchemeOption::Kind::text, "none",
                                "Levels whose weights keep the control points of small faces apart: none, first, all"};

namespace {

constexpr SchemeOption kConvert{
    "--convert", SchemeOption::Kind::text, "auto",
    "How a mesh that isn't three-valent is made so before level 1: auto, none, dual, trisect, akleman"};

struct Tuning {
  std::string_view name;
  Far::HalfBoxTuning tuning;
};
constexpr std::array kTunings{Tuning{"none", Far::HalfBoxTuning::none}, Tuning{"first", Far::HalfBoxTuning::first},
                              Tuning{"all", Far::HalfBoxTuning::all}};

struct Conversion {
  std::string_view name;
  Far::HalfBoxConversion conversion;
};
constexpr std::array kConversions{
    Conversion{"auto", Far::HalfBoxConversion::automatic}, Conversion{"none", Far::HalfBoxConversion::none},
    Conversion{"dual", Far::HalfBoxConversion::dual}, Conversion{"trisect", Far::HalfBoxConversion::trisect},
    Conversion{"akleman", Far::HalfBoxConversion::akleman}};

Result<std::vector<Far::Scheme>> make(const SchemeRequest& request) {
  const auto tuning = choose(kTunings, kTunedOption.name, request.options.text(kTunedOption));
  if (!tuning) return tl::unexpected(tuning.error());
  const auto conversion = choose(kConversions, kConvert.name, request.options.text(kConvert));
  if (!conversion) return tl::unexpected(conversion.error());
  Far::HalfBoxOptions halfBox;
  halfBox.tuning = (*tuning)->tuning;
  halfBox.conversion = (*conversion)->conversion;
  if (request.boundary == "clamped") halfBox.boundary = Far::HalfBoxBoundary::clamped;
  Result<std::vector<Far::Scheme>> steps = Far::halfBox(request.mesh, request.levels, halfBox);
  if (!steps && steps.error().code == ErrorCode::invalidMesh && halfBox.conversion == Far::HalfBoxConversion::none)
    steps.error().message += ", as --convert auto does";
  return steps;
}

constexpr std::array kOptions{&kTunedOption, &kConvert, &kBoundaryOption};
constexpr std::array<std::string_view, 2> kBoundaries{"natural", "clamped"};

}  // namespace

const SchemeEntry kHalfBox{"half-box", make, kOptions, kBoundaries, true, false, true, true};

}  // namespace honeycomb::Chain
