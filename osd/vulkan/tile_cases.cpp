#include "osd/vulkan/tile_cases.h"

#include <optional>

namespace honeycomb::Osd {

namespace {

using Far::CirculantForm;
using Far::TileStep;

// The number of a shape that has a kernel of its own.
std::optional<std::uint32_t> shapeOf(const TileStep& step) {
  if (step.form == CirculantForm::quad) return 0;
  if (step.form == CirculantForm::hexagon) return 1;
  if (step.form == CirculantForm::evenOdd && step.width <= 8) return 2 + static_cast<std::uint32_t>(step.width - 4) / 2;
  if (step.form == CirculantForm::direct && step.width <= 7) return 5 + static_cast<std::uint32_t>(step.width - 3) / 2;
  return std::nullopt;
}

}  // namespace

std::uint32_t caseOf(const TileStep& step, TileStages stages) {
  const auto offset = static_cast<std::uint32_t>(stages);
  if (step.kind == TileStep::Kind::dense) return caseAfter(TileCase::dense, offset);
  if (step.kind == TileStep::Kind::loose) return caseAfter(TileCase::loose, offset);
  const auto shape = shapeOf(step);
  return shape ? caseAfter(TileCase::shapes, 4 * *shape + offset) : static_cast<std::uint32_t>(TileCase::anySides);
}

}  // namespace honeycomb::Osd
