#include "far/schemes/half_box.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include "far/schemes/akleman.h"
#include "far/schemes/dual.h"
#include "far/schemes/half_box_creases.h"
#include "far/schemes/trisect.h"
#include "far/topology/splits/chamfer.h"
#include "far/topology/three_valent.h"

namespace honeycomb::Far {

namespace {

Split threeValentChamfer() {
  Split split = chamfer();
  split.apply = [chamfered = split.apply](const Topology& parent) -> Result<SplitResult> {
    if (const auto three = checkThreeValent(parent); !three) return tl::unexpected(three.error());
    return chamfered(parent);
  };
  return split;
}

Result<void> checkWeights(const TunedWeights& weights) {
  for (const auto& entry : weights) {
    if (entry.second >= 1.0 / 6 && entry.second <= 0.5) continue;
    return fail(ErrorCode::invalidOption,
                fmt::format("weight {} of faces with {} sides is out of range; it must lie in [1/6, 1/2]", entry.second,
                            entry.first));
  }
  return {};
}

HalfBoxConversion chooseConversion(const Topology& control, HalfBoxConversion wanted) {
  if (wanted != HalfBoxConversion::automatic) return wanted;
  if (firstNotThreeValent(control) < 0) return HalfBoxConversion::none;
  const auto runs = control.runs();
  const bool triangles = std::all_of(runs.begin(), runs.end(), [](const FaceRun& run) { return run.sides == 3; });
  return triangles ? HalfBoxConversion::dual : HalfBoxConversion::akleman;
}

Result<std::optional<Scheme>> conversionStep(const Topology& control, HalfBoxConversion wanted) {
  switch (chooseConversion(control, wanted)) {
    case HalfBoxConversion::dual:
      return std::optional<Scheme>(dualStep());
    case HalfBoxConversion::trisect:
      return trisect().map([](Scheme scheme) { return std::optional<Scheme>(std::move(scheme)); });
    case HalfBoxConversion::akleman:
      return akleman().map([](Scheme scheme) { return std::optional<Scheme>(std::move(scheme)); });
    default:
      break;
  }
  if (const auto three = checkThreeValent(control); !three) return tl::unexpected(three.error());
  return std::optional<Scheme>();
}

}  // namespace

double boundedCurvatureWeight(std::int32_t sides) {
  const double c = std::cos(4 * std::numbers::pi / sides);
  return -0.75 * c / (1 - c);
}

Result<Scheme> halfBoxStep(const HalfBoxOptions& options, bool tuned) {
  if (const auto checked = checkWeights(options.tunedWeights); !checked) return tl::unexpected(checked.error());
  const TunedWeights weights = tuned ? options.tunedWeights : TunedWeights{};
  if (options.boundary == HalfBoxBoundary::clamped) return clampedHalfBoxStep(weights, options.corners);
  Scheme scheme;
  scheme.name = "half-box";
  scheme.split = threeValentChamfer();
  scheme.faceRule = halfBoxRule;
  scheme.vertexLimits = VertexLimits::patchCentre;
  scheme.entriesPerVertex = 2;
  scheme.pointRow = [weights](const SourceLevel& parent, const NewPoint& point, Row& row) {
    addHalfBoxVertexRow(parent.topology(), point.halfEdge, weights, row);
  };
  return scheme;
}

Result<std::vector<Scheme>> halfBox(const Topology& control, std::int32_t levels, const HalfBoxOptions& wanted) {
  HalfBoxOptions options = wanted;
  const bool creased = !control.creases().empty();
  if (control.closed()) options.boundary = HalfBoxBoundary::natural;
  if (creased) {
    if (const auto chosen = chooseForCreases(control, options); !chosen) return tl::unexpected(chosen.error());
  }
  Result<std::optional<Scheme>> conversion = conversionStep(control, options.conversion);
  if (!conversion) return tl::unexpected(conversion.error());
  std::vector<Scheme> chain;
  if (*conversion) chain.push_back(std::move(**conversion));
  if (options.boundary == HalfBoxBoundary::clamped && levels > 0) {
    chain.push_back(creased ? clampBricksStep() : clampStep());
  }
  for (std::int32_t level = 0; level < levels; ++level) {
    const bool tuned = options.tuning == HalfBoxTuning::all || (options.tuning == HalfBoxTuning::first && level == 0);
    Result<Scheme> step = halfBoxStep(options, tuned);
    if (!step) return tl::unexpected(step.error());
    chain.push_back(std::move(*step));
  }
  if (options.tuning == HalfBoxTuning::first && levels == 1) {
    Result<Scheme> plain = halfBoxStep(options, false);
    if (!plain) return tl::unexpected(plain.error());
    chain.back().after = std::make_shared<const Scheme>(std::move(*plain));
  }
  return chain;
}

}  // namespace honeycomb::Far
