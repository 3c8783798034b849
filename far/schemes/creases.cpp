#include "far/schemes/creases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace honeycomb::Far {

namespace {

Result<void> checkStep(const Topology& control, const Scheme& scheme, const CreaseEdge& crease) {
  const auto refuse = [&](std::string_view why) -> Result<void> { return refuseCrease(control, crease, why); };
  if (scheme.creases.reach == CreaseRule::Reach::none) {
    return refuse(fmt::format("{} has no rule for creases; remove them, or use akleman or zhang-wang", scheme.name));
  }
  if (scheme.creases.reach == CreaseRule::Reach::infinite && !std::isinf(crease.sharpness)) {
    return refuse(
        fmt::format("{} has no rule for creases that become smooth, and its sharpness is {}; give it {}, "
                    "which is infinite, or use akleman or zhang-wang",
                    scheme.name, crease.sharpness, kSharp));
  }
  if (!control.closed() && !scheme.creases.borders) {
    return refuse("on a mesh with a border, creases need the brick rule there too; choose the brick boundary");
  }
  return {};
}

}  // namespace

tl::unexpected<Error> refuseCrease(const Topology& control, const CreaseEdge& crease, std::string_view why) {
  const auto ends = std::minmax({control.vert(crease.halfEdge), control.dest(crease.halfEdge)});
  return fail(ErrorCode::invalidOption,
              fmt::format("the crease between vertices {} and {} (counted from 0): {}", ends.first, ends.second, why),
              ends.first);
}

Result<void> checkCreases(const Topology& control, std::span<const Scheme> chain) {
  double step = 0;
  for (const Scheme& scheme : chain) {
    for (const CreaseEdge& crease : control.creases()) {
      if (!(crease.sharpness > step)) continue;
      if (auto checked = checkStep(control, scheme, crease); !checked) return checked;
    }
    ++step;
  }
  return {};
}

}  // namespace honeycomb::Far
