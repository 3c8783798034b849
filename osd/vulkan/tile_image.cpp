#include "osd/vulkan/tile_image.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <numeric>

#include "far/base/index.h"

namespace honeycomb::Osd {

namespace {

using Far::TileStep;

constexpr TileWord kSharedImport = 0x80000000U;

/// Of a tile in an image: its numbers are halves of words.
constexpr TileWord kMostOwnPoints = 65536;

}  // namespace

Result<std::vector<TileImage>> TileImageBuilder::build(std::span<const std::int32_t> tiles) {
  for (const std::int32_t tile : tiles) {
    if (auto added = addWhole([&] { addTile(tile); }); !added) return tl::unexpected(added.error());
  }
  if (normals_ == Far::TileNormalKind::fast) {
    if (auto added = addSharedNormals(); !added) return tl::unexpected(added.error());
  }
  if (!tiles_.empty()) finish();
  return std::move(images_);
}

// What `add` adds stands in one image: where it passes this one's end, in the next.
Result<void> TileImageBuilder::addWhole(const std::function<void()>& add) {
  const TileWord begin = texels();
  const std::size_t tilesBefore = tiles_.size();
  const std::uint64_t casesBefore = image_.cases;
  const auto fits = [&] { return texels() + tiles_.size() / kTexelWords <= mostTexels_; };
  add();
  if (largest_ > kMostOwnPoints) return fail(ErrorCode::tooLarge, "a tile keeps more points than can be told apart");
  if (fits()) return {};
  if (tilesBefore > 0) {
    image_.words.resize(std::size_t{begin} * kTexelWords);
    image_.cases = casesBefore;
    tiles_.resize(tilesBefore);
    finish();
    add();
    if (fits()) return {};
  }
  return fail(ErrorCode::tooLarge,
              fmt::format("a tile's table passes this Vulkan device's {} texels: use smaller tiles "
                          "(TileOptions::scratchPoints) or refine level by level",
                          mostTexels_));
}

void TileImageBuilder::fillTexel() {
  image_.words.resize((image_.words.size() + kTexelWords - 1) / kTexelWords * kTexelWords);
}

// Two numbers a word.
void TileImageBuilder::pushHalves(std::span<const TileWord> numbers) {
  for (std::size_t i = 0; i < numbers.size(); i += 2) {
    const TileWord second = i + 1 < numbers.size() ? numbers[i + 1] : 0;
    image_.words.push_back(numbers[i] | second << 16U);
  }
}

void TileImageBuilder::finish() {
  image_.firstTile = texels();
  image_.tileCount = static_cast<std::uint32_t>(tiles_.size() / kTexelWords);
  image_.words.insert(image_.words.end(), tiles_.begin(), tiles_.end());
  // Each step goes through the branches of all cases, where a loop that has nothing to do turns once.
  constexpr std::uint64_t kMostLoops = 8;
  image_.turns += mostSteps_ * (1 + kMostLoops * static_cast<std::uint64_t>(std::popcount(image_.cases)));
  images_.push_back(std::move(image_));
  image_ = {};
  mostSteps_ = 0;
  tiles_.clear();
  weights_.clear();
  tangentWeights_.clear();
}

// The kernels keep a step's points face after face, whatever TilePlaces says, and stage after stage, so that one number
// leads from each to the next. It is even, as the first is: two points of a face are one store where stores may be
// long.
void TileImageBuilder::numberPoints(const Far::Tile& tile) {
  numbers_.resize(at(tile.pointCount));
  std::iota(numbers_.begin(), numbers_.begin() + tile.importCount, 0);
  pointCount_ = static_cast<TileWord>(tile.importCount);
  for (const TileStep& step : std::span(table_.steps).subspan(at(tile.firstStep), at(tile.stepCount))) {
    for (const Far::TileStage& stage : std::span(table_.stages).subspan(at(step.firstStage), step.stageCount)) {
      if (stage.firstPoint < 0) continue;
      numberStage(step, stage.firstPoint, evenFrom(pointCount_));
      pointCount_ = evenFrom(pointCount_) + stageStride(step);
    }
  }
}

TileWord TileImageBuilder::stageStride(const TileStep& step) {
  return evenFrom(static_cast<TileWord>(step.count * step.pointsEach()));
}

void TileImageBuilder::numberStage(const TileStep& step, std::int32_t firstPoint, TileWord number) {
  const Far::TilePlaces places = step.placesIn(table_.places);
  const std::int32_t points = step.pointsEach();
  for (std::int32_t item = 0; item < step.count; ++item) {
    const Far::FacePlaces place = Far::placesOfFace(places, item, points);
    for (std::int32_t i = 0; i < points; ++i) numbers_[at(firstPoint + place.first + i * place.step)] = number++;
    if (places == Far::TilePlaces::fours) numbers_[at(firstPoint + place.first - place.step)] = number - 1;
  }
}

void TileImageBuilder::addTile(std::int32_t number) {
  const Far::Tile& tile = table_.tiles[at(number)];
  numberPoints(tile);
  const TileWord firstImport = texels();
  addImports(tile);
  std::int32_t level = table_.rootLevel;
  for (const TileStep& step : std::span(table_.steps).subspan(at(tile.firstStep), at(tile.stepCount))) {
    const std::size_t before = steps_.size();
    addStep(step);
    if (steps_.size() == before) continue;
    steps_[before + 6] = step.level != level ? 1 : 0;
    level = step.level;
  }
  firstNormal_ = pointCount_;
  largest_ = std::max(largest_, firstNormal_);
  if (normals_ == Far::TileNormalKind::fast) addFastNormals(number);
  if (normals_ == Far::TileNormalKind::exact) addExactNormals(number);
  closeTile(firstImport, tile.importCount);
}

// At a lower level a tile may have nothing to do.
void TileImageBuilder::closeTile(TileWord firstImport, std::int32_t imports) {
  if (steps_.empty()) return;
  const TileWord firstStep = texels();
  image_.words.insert(image_.words.end(), steps_.begin(), steps_.end());
  const auto stepCount = static_cast<TileWord>(steps_.size() / (2 * kTexelWords));
  tiles_.insert(tiles_.end(), {firstImport, static_cast<TileWord>(imports), firstStep, stepCount});
  image_.turns = std::max(image_.turns, turns_ + turnsOver(static_cast<TileWord>(imports)));
  mostSteps_ = std::max(mostSteps_, stepCount);
  steps_.clear();
  turns_ = 0;
}

void TileImageBuilder::addImports(const Far::Tile& tile) {
  for (const std::int32_t point : std::span(table_.imports).subspan(at(tile.firstImport), at(tile.importCount))) {
    const bool ofRoot = point < table_.rootPoints;
    image_.words.push_back(ofRoot ? static_cast<TileWord>(point)
                                  : static_cast<TileWord>(point - table_.rootPoints) | kSharedImport);
  }
  fillTexel();
}

// Nothing where the step has no stage that the wanted level needs. A step that goes on behind the wanted level is two:
// up to that, and once more with all that is kept.
void TileImageBuilder::addStep(const TileStep& step) {
  const std::int32_t stages = Kernels::stagesFor(table_, step, level_, last_);
  if (stages < 1) return;
  const std::int32_t wanted = level_ - step.level;
  const bool written = wanted >= 0 && wanted < stages && table_.stages[at(step.firstStage + wanted)].firstOutput >= 0;
  const TileWord record = step.kind == TileStep::Kind::loose ? addRows(step, written) : addRecords(step, written);
  const TileWord firstStage = addStages(step, stages);
  image_.sameWeights = image_.sameWeights && step.sameWeights;
  const auto push = [&](TileStages what, std::int32_t kept, TileWord writes) {
    pushStep({caseOf(step, what), static_cast<TileWord>(step.count), record, static_cast<TileWord>(step.width),
              firstStage, static_cast<TileWord>(kept), 0, writes},
             innerTurns(step, stages));
  };
  if (!written) return push(TileStages::kept, stages, 0);
  if (last_ == level_) return push(wanted > 0 ? TileStages::both : TileStages::written, wanted, 1);
  push(TileStages::also, wanted + 1, 2);
  if (stages > wanted + 1) push(TileStages::kept, stages, 0);
}

// Of the loops over what an item reads, for the item that reads most: invocations wait for each other.
std::uint64_t TileImageBuilder::innerTurns(const TileStep& step, std::int32_t stages) const {
  const auto width = static_cast<std::uint64_t>(step.width);
  if (step.kind == TileStep::Kind::dense) return width;
  if (step.kind == TileStep::Kind::loose) {
    const std::span rows = std::span(table_.rows).subspan(at(step.firstRow), at(step.count));
    const auto longest = std::ranges::max_element(rows, {}, &Far::TileRow::entries);
    return longest == rows.end() ? 0 : static_cast<std::uint64_t>(longest->entries);
  }
  const bool unrolled = caseOf(step, TileStages::kept) != static_cast<TileWord>(TileCase::anySides);
  return static_cast<std::uint64_t>(stages) * (unrolled ? 1 : width * (width + 5));
}

void TileImageBuilder::pushStep(StepWords words, std::uint64_t innerTurns) {
  image_.cases |= std::uint64_t{1} << words[0];
  turns_ += turnsOver(words[1]) * (1 + innerTurns);
  steps_.insert(steps_.end(), words.begin(), words.end());
}

// Where the points of the wanted level go.
Kernels::Outputs TileImageBuilder::outputs(const TileStep& step) const {
  return Kernels::stageTarget(table_, step, level_ - step.level, level_, last_).outputs;
}

TileWord TileImageBuilder::addRecords(const TileStep& step, bool written) {
  const TileWord begin = texels();
  const bool faces = step.kind == TileStep::Kind::circulant;
  const Kernels::Outputs outputs = written ? this->outputs(step) : Kernels::Outputs{};
  const Far::TileCorners read = Kernels::cornersOf(table_, step);
  std::vector<Far::TilePoint> room(at(step.width));
  std::vector<TileWord> corners(at(step.width));
  for (std::int32_t item = 0; item < step.count; ++item) {
    const Far::TilePoint* index = read.of(item, room.data());
    std::transform(index, index + step.width, corners.begin(), [&](Far::TilePoint p) { return ownNumber(p); });
    pushHalves(corners);
    const auto first = written ? static_cast<TileWord>(outputs.of(item, step.pointsEach())) : 0;
    image_.words.push_back(first);
    image_.pairs = image_.pairs && (!faces || step.width % 2 != 0 || first % 2 == 0);
    image_.fours = image_.fours && image_.pairs && (!faces || step.width % 4 != 0 || first % 4 == 0);
    fillTexel();
  }
  return begin;
}

TileWord TileImageBuilder::addRows(const TileStep& step, bool written) {
  const std::span rows = std::span(table_.rows).subspan(at(step.firstRow), at(step.count));
  const Kernels::Outputs outputs = written ? this->outputs(step) : Kernels::Outputs{};
  const TileWord first = texels();
  TileWord entry = first + static_cast<TileWord>(step.count);
  for (std::int32_t r = 0; r < step.count; ++r) {
    const auto entries = static_cast<TileWord>(rows[at(r)].entries);
    image_.words.insert(image_.words.end(), {entry, entries, written ? static_cast<TileWord>(outputs.of(r, 1)) : 0, 0});
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
    const Far::FacePlaces place = Far::placesOfFace(step.placesIn(table_.places), 0, step.pointsEach());
    const TileWord kept = stage.firstPoint < 0 ? 0 : numbers_[at(stage.firstPoint + place.first)];
    words.insert(words.end(), {kept, weight, stageStride(step), 0});
  }
  const TileWord first = texels();
  image_.words.insert(image_.words.end(), words.begin(), words.end());
  return first;
}

// Where the image has these weights, which tiles share. Those of a tile that went to the next image are not there.
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
