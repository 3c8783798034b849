#include "osd/vulkan/tile_image.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <numeric>

#include "far/base/index.h"
#include "osd/tile_kernels.h"

namespace honeycomb::Osd {

namespace {

using Far::CirculantForm;
using Far::TileStep;

constexpr TileWord kSharedImport = 0x80000000U;

// The cases of shaders/tile.glsl.
constexpr TileWord kAnySides = 24;
constexpr TileWord kFirstDense = 25;
constexpr TileWord kFirstLoose = 27;

// The first of the three cases of a shape that has a kernel of its own.
TileWord facesCase(const TileStep& step) {
  if (step.form == CirculantForm::quad) return 0;
  if (step.form == CirculantForm::hexagon) return 3;
  if (step.form == CirculantForm::evenOdd && step.width <= 8)
    return 6 + 3 * (static_cast<TileWord>(step.width - 4) / 2);
  if (step.form == CirculantForm::direct && step.width <= 7)
    return 15 + 3 * (static_cast<TileWord>(step.width - 3) / 2);
  return kAnySides;
}

TileWord caseOf(const TileStep& step, std::int32_t kept, bool written) {
  if (step.kind == TileStep::Kind::dense) return kFirstDense + (written ? 1 : 0);
  if (step.kind == TileStep::Kind::loose) return kFirstLoose + (written ? 1 : 0);
  const TileWord first = facesCase(step);
  if (first == kAnySides || !written) return first;
  return first + (kept > 0 ? 1 : 2);
}

}  // namespace

Result<std::vector<TileImage>> TileImageBuilder::build(std::span<const std::int32_t> tiles) {
  std::vector<TileImage> images;
  for (std::size_t i = 0; i < tiles.size();) {
    const TileWord begin = texels();
    const std::size_t tilesBefore = tiles_.size();
    const std::uint32_t casesBefore = image_.cases;
    addTile(table_.tiles[at(tiles[i])]);
    if (texels() + tiles_.size() / kTexelWords <= mostTexels_) {
      ++i;
      continue;
    }
    if (tilesBefore == 0) {
      return fail(ErrorCode::tooLarge,
                  fmt::format("a tile's table passes this Vulkan device's {} texels: use smaller tiles "
                              "(TileOptions::scratchPoints) or refine level by level",
                              mostTexels_));
    }
    image_.words.resize(std::size_t{begin} * kTexelWords);
    image_.cases = casesBefore;
    std::erase_if(weights_, [&](const auto& one) { return one.second >= begin; });
    tiles_.resize(tilesBefore);
    finish(images);
  }
  if (!tiles_.empty()) finish(images);
  return images;
}

void TileImageBuilder::fillTexel() {
  image_.words.resize((image_.words.size() + kTexelWords - 1) / kTexelWords * kTexelWords);
}

void TileImageBuilder::finish(std::vector<TileImage>& images) {
  image_.firstTile = texels();
  image_.tileCount = static_cast<std::uint32_t>(tiles_.size() / kTexelWords);
  image_.words.insert(image_.words.end(), tiles_.begin(), tiles_.end());
  images.push_back(std::move(image_));
  image_ = {};
  tiles_.clear();
  weights_.clear();
}

// The kernels keep a step's points face after face, whatever TilePlaces says.
void TileImageBuilder::numberPoints(const Far::Tile& tile) {
  numbers_.resize(at(tile.pointCount));
  std::iota(numbers_.begin(), numbers_.end(), 0);
  if (table_.places == Far::TilePlaces::faces) return;
  for (const TileStep& step : std::span(table_.steps).subspan(at(tile.firstStep), at(tile.stepCount))) {
    if (step.kind != TileStep::Kind::circulant) continue;
    for (const Far::TileStage& stage : std::span(table_.stages).subspan(at(step.firstStage), step.stageCount)) {
      if (stage.firstPoint < 0) continue;
      TileWord number = static_cast<TileWord>(stage.firstPoint);
      for (std::int32_t face = 0; face < step.count; ++face) {
        const Far::FacePlaces places = Far::placesOfFace(table_.places, face, step.count, step.width);
        const std::int32_t first = stage.firstPoint + places.first;
        for (std::int32_t i = 0; i < step.width; ++i) numbers_[at(first + i * places.step)] = number++;
      }
    }
  }
}

void TileImageBuilder::addTile(const Far::Tile& tile) {
  numberPoints(tile);
  const TileWord firstImport = texels();
  addImports(tile);
  std::vector<TileWord> steps;
  std::int32_t level = table_.rootLevel;
  for (const TileStep& step : std::span(table_.steps).subspan(at(tile.firstStep), at(tile.stepCount))) {
    const auto words = this->step(step);
    if (!words) continue;
    steps.insert(steps.end(), words->begin(), words->end());
    steps[steps.size() - 2] = step.level != level ? 1 : 0;
    level = step.level;
  }
  // At a lower level a tile may have nothing to do.
  if (steps.empty()) return;
  const TileWord firstStep = texels();
  image_.words.insert(image_.words.end(), steps.begin(), steps.end());
  const auto stepCount = static_cast<TileWord>(steps.size() / (2 * kTexelWords));
  const std::array tileWords = {firstImport, static_cast<TileWord>(tile.importCount), firstStep, stepCount};
  tiles_.insert(tiles_.end(), tileWords.begin(), tileWords.end());
}

void TileImageBuilder::addImports(const Far::Tile& tile) {
  for (const std::int32_t point : std::span(table_.imports).subspan(at(tile.firstImport), at(tile.importCount))) {
    const bool ofRoot = point < table_.rootPoints;
    image_.words.push_back(ofRoot ? static_cast<TileWord>(point)
                                  : static_cast<TileWord>(point - table_.rootPoints) | kSharedImport);
  }
  fillTexel();
}

// Nothing where the step has no stage that the wanted level needs.
std::optional<std::array<TileWord, 2 * kTexelWords>> TileImageBuilder::step(const TileStep& step) {
  const std::int32_t stages = Kernels::stagesFor(table_, step, level_, level_);
  if (stages < 1) return std::nullopt;
  const bool written = step.level + stages - 1 == level_;
  const std::int32_t kept = written ? stages - 1 : stages;
  const TileWord which = caseOf(step, kept, written);
  image_.cases |= TileWord{1} << which;
  const TileWord firstRecord =
      step.kind == TileStep::Kind::loose ? addRows(step, written) : addRecords(step, written, stages - 1);
  const TileWord firstStage = addStages(step, stages);
  return std::array<TileWord, 2 * kTexelWords>{
      which,      static_cast<TileWord>(step.count), firstRecord, static_cast<TileWord>(step.width),
      firstStage, static_cast<TileWord>(kept),       0,           written ? 1U : 0U};
}

TileWord TileImageBuilder::output(const TileStep& step, std::int32_t stage, std::int32_t item) const {
  const std::int32_t each = step.kind == TileStep::Kind::circulant ? step.width : 1;
  return static_cast<TileWord>(Kernels::stageTarget(table_, step, stage, level_, level_).outputs.of(item, each));
}

TileWord TileImageBuilder::addRecords(const TileStep& step, bool written, std::int32_t stage) {
  const TileWord begin = texels();
  const Far::TilePoint* index = table_.indices.data() + step.firstIndex;
  for (std::int32_t item = 0; item < step.count; ++item, index += step.width) {
    for (std::int32_t i = 0; i < step.width; i += 2) {
      const TileWord second = i + 1 < step.width ? ownNumber(index[i + 1]) : 0;
      image_.words.push_back(ownNumber(index[i]) | second << 16U);
    }
    const TileWord first = written ? output(step, stage, item) : 0;
    image_.words.push_back(first);
    image_.pairs = image_.pairs && (step.width % 2 != 0 || first % 2 == 0 || step.kind != TileStep::Kind::circulant);
    fillTexel();
  }
  return begin;
}

TileWord TileImageBuilder::addRows(const TileStep& step, bool written) {
  const std::span rows = std::span(table_.rows).subspan(at(step.firstRow), at(step.count));
  const TileWord first = texels();
  TileWord entry = first + static_cast<TileWord>(step.count);
  for (std::int32_t r = 0; r < step.count; ++r) {
    const auto entries = static_cast<TileWord>(rows[at(r)].entries);
    image_.words.insert(image_.words.end(), {entry, entries, written ? output(step, 0, r) : 0, 0});
    entry += (entries + 1) / 2;
  }
  const Far::TilePoint* index = table_.indices.data() + step.firstIndex;
  for (const Far::TileRow& row : rows) {
    for (std::int32_t i = 0; i < row.entries; ++i) {
      const float weight = table_.weightsSingle[at(row.firstWeight + i)];
      image_.words.insert(image_.words.end(), {ownNumber(*index++), std::bit_cast<TileWord>(weight)});
    }
    fillTexel();
  }
  return first;
}

TileWord TileImageBuilder::addStages(const TileStep& step, std::int32_t stages) {
  std::vector<TileWord> words;
  for (std::int32_t s = 0; s < stages; ++s) {
    const Far::TileStage& stage = table_.stages[at(step.firstStage + s)];
    TileWord weight = 0;
    if (step.kind == TileStep::Kind::circulant) {
      weight = weights(stage.firstWeight, Far::formWeightCount(step.form, step.width));
    }
    if (step.kind == TileStep::Kind::dense) weight = weights(stage.firstWeight, step.width);
    words.insert(words.end(), {static_cast<TileWord>(stage.firstPoint), weight, 0, 0});
  }
  const TileWord first = texels();
  image_.words.insert(image_.words.end(), words.begin(), words.end());
  return first;
}

// Where the image has these weights, which tiles share.
TileWord TileImageBuilder::weights(std::int32_t first, std::int32_t count) {
  const auto [place, isNew] = weights_.try_emplace(first, texels());
  if (!isNew) return place->second;
  for (std::int32_t k = 0; k < count; ++k) {
    image_.words.push_back(std::bit_cast<TileWord>(table_.weightsSingle[at(first + k)]));
  }
  fillTexel();
  return place->second;
}

}  // namespace honeycomb::Osd
