#include <algorithm>
#include <bit>

#include "far/base/index.h"
#include "osd/tile_normal_kernels.h"
#include "osd/vulkan/tile_image.h"

namespace honeycomb::Osd {

namespace {

using Far::TileStep;

/// Normals that tiles of sums alone keep at once; one point sums at most kMostSummedNormals.
constexpr std::int32_t kSharedAtOnce = 256;

constexpr std::uint32_t kHexagon = 6;

/// In TileImageBuilder::tangentWeights_, where there are no weights of the table.
constexpr std::int32_t kNoneKey = -1, kHexagonKey = -2;

}  // namespace

// First the normals of the faces, behind the tile's points, then those of its vertices.
void TileImageBuilder::addFastNormals(std::int32_t number) {
  const Far::TileNormals& normals = table_.normals;
  const Far::TileNormalRange& range = normals.tiles[at(number)];
  largest_ = std::max(largest_, firstNormal_ + static_cast<TileWord>(range.normalCount));
  const std::size_t begin = steps_.size();
  addImportedNormals(std::span(normals.imports).subspan(at(range.firstImport), at(range.importCount)), firstNormal_);
  Kernels::forTileFrames(
      table_, number,
      [&](const Far::TileFrames& frames, const Far::TileCorners& corners, std::int32_t first, std::int32_t) {
        addFaceNormals(frames, corners, firstNormal_ + static_cast<TileWord>(first));
      });
  if (begin < steps_.size()) steps_[begin + 6] = 1;
  const std::size_t vertices = steps_.size();
  const Far::Tile& tile = table_.tiles[at(number)];
  for (std::int32_t s = tile.firstStep; s < tile.firstStep + tile.stepCount; ++s) {
    if (normals.firstFace[at(s)] < 0) continue;
    const TileStep& step = table_.steps[at(s)];
    const Far::TilePoint* faces = normals.faces.data() + normals.firstFace[at(s)];
    step.kind == TileStep::Kind::circulant ? addCornerNormals(step, faces) : addSummedNormals(step, faces);
  }
  if (vertices < steps_.size()) steps_[vertices + 6] = 1;
}

void TileImageBuilder::addImportedNormals(std::span<const std::int32_t> normals, TileWord place) {
  if (normals.empty()) return;
  const TileWord first = texels();
  image_.words.insert(image_.words.end(), normals.begin(), normals.end());
  fillTexel();
  pushStep({caseAfter(TileCase::importedNormals, 0), static_cast<TileWord>(normals.size()), first, 0, 0, place, 0, 0},
           0);
}

void TileImageBuilder::addFaceNormals(const Far::TileFrames& frames, const Far::TileCorners& read, TileWord place) {
  const auto sides = static_cast<TileWord>(frames.sides);
  const TileWord weights = tangentWeights(table_.normals.weightsSingle, frames.firstWeight, frames.sides);
  const TileWord first = texels();
  std::vector<Far::TilePoint> room(sides);
  std::vector<TileWord> corners(sides);
  for (std::int32_t g = 0; g < frames.count; ++g) {
    const Far::TilePoint* index = read.of(g, room.data());
    std::transform(index, index + sides, corners.begin(), [&](Far::TilePoint p) { return ownNumber(p); });
    pushHalves(corners);
    image_.words.push_back(0);
    fillTexel();
  }
  pushStep({caseAfter(TileCase::faceNormals, sides == kHexagon ? 0 : 1), static_cast<TileWord>(frames.count), first,
            sides, weights, place, 0, 0},
           sides);
}

void TileImageBuilder::addCornerNormals(const TileStep& step, const Far::TilePoint* faces) {
  const auto neighbours = static_cast<TileWord>(table_.normals.neighbours);
  const auto width = static_cast<TileWord>(step.width);
  const Kernels::Outputs outputs = Kernels::lastOutputs(table_, step);
  const TileWord first = texels();
  std::vector<TileWord> numbers(1 + width * neighbours);
  for (std::int32_t g = 0; g < step.count; ++g) {
    for (TileWord& number : numbers) number = firstNormal_ + *faces++ / 2U;
    pushHalves(numbers);
    image_.words.push_back(static_cast<TileWord>(outputs.of(g, step.width)));
    fillTexel();
  }
  const bool common = width == kHexagon && neighbours == 1;
  pushStep({caseAfter(TileCase::cornerNormals, common ? 0 : 1), static_cast<TileWord>(step.count), first, width, 0,
            neighbours, 0, 1},
           width * (1 + neighbours));
}

void TileImageBuilder::addSummedNormals(const TileStep& step, const Far::TilePoint* faces) {
  const Kernels::Outputs outputs = Kernels::lastOutputs(table_, step);
  std::vector<NormalSum> sums;
  std::vector<TileWord> normals;
  for (std::int32_t r = 0; r < step.count; ++r) {
    const std::int32_t count = *faces++;
    sums.push_back({static_cast<std::int32_t>(normals.size()), count, static_cast<TileWord>(outputs.of(r, 1))});
    for (std::int32_t i = 0; i < count; ++i) normals.push_back(firstNormal_ + *faces++ / 2U);
  }
  addSums(sums, normals);
}

// Records, then the normals of each point from a texel on.
void TileImageBuilder::addSums(std::span<const NormalSum> sums, std::span<const TileWord> normals) {
  const TileWord first = texels();
  TileWord entry = first + static_cast<TileWord>(sums.size());
  for (const NormalSum& sum : sums) {
    const auto count = static_cast<TileWord>(sum.count);
    image_.words.insert(image_.words.end(), {entry, count, sum.output, 0});
    entry += (count + 7) / 8;
  }
  for (const NormalSum& sum : sums) {
    pushHalves(normals.subspan(at(sum.first), at(sum.count)));
    fillTexel();
  }
  const auto longest = std::ranges::max_element(sums, {}, &NormalSum::count);
  pushStep({caseAfter(TileCase::summedNormals, 0), static_cast<TileWord>(sums.size()), first, 0, 0, 0, 0, 1},
           longest == sums.end() ? 0 : static_cast<std::uint64_t>(longest->count));
}

// Points that are no vertices have the zero vector: that of a point whose weights are zero.
void TileImageBuilder::addExactNormals(std::int32_t number) {
  const Far::TileLimits& limits = table_.limits;
  const Far::TileLimits::Range& range = limits.tiles[at(number)];
  const std::size_t begin = steps_.size();
  for (const Far::TileVertexFrames& frames : std::span(limits.frames).subspan(at(range.first), at(range.count))) {
    const auto sides = static_cast<TileWord>(std::max(frames.sides, 1));
    const TileWord weights = frames.sides > 0 ? tangentWeights(limits.weightsSingle, frames.firstWeight, frames.sides)
                                              : tangentWeights({}, kNoneKey, 1);
    const Kernels::Outputs outputs = Kernels::outputsFrom(table_, frames.firstOutput);
    const TileWord first = texels();
    const Far::TilePoint* index = limits.indices.data() + frames.firstIndex;
    std::vector<TileWord> points(sides);
    for (std::int32_t i = 0; i < frames.count * frames.each; ++i, index += frames.sides) {
      std::transform(index, index + frames.sides, points.begin(), [&](Far::TilePoint p) { return ownNumber(p); });
      pushHalves(points);
      image_.words.push_back(static_cast<TileWord>(outputs.of(i / frames.each, frames.each) + i % frames.each));
      fillTexel();
    }
    pushStep({caseAfter(TileCase::vertexNormals, sides == kHexagon ? 0 : 1),
              static_cast<TileWord>(frames.count * frames.each), first, sides, weights, 0, 0, 1},
             sides);
  }
  if (begin < steps_.size()) steps_[begin + 6] = 1;
  const Far::TileLimits::Range& rings = limits.ringTiles[at(number)];
  addRings(std::span(limits.rings).subspan(at(rings.first), at(rings.count)));
}

// The faces' points of the level behind are kept behind all others, face after face, then each vertex reads its six.
void TileImageBuilder::addRings(std::span<const Far::TileRings> rings) {
  TileWord place = evenFrom(pointCount_);
  const std::size_t faces = steps_.size();
  std::vector<TileWord> places;
  for (const Far::TileRings& some : rings) {
    const Kernels::RingFaces ring = Kernels::ringFaces(table_, some);
    places.push_back(place);
    addRingFaces(ring, place);
    place += stageStride(ring.step);
  }
  if (faces < steps_.size()) steps_[faces + 6] = 1;
  const std::size_t vertices = steps_.size();
  for (std::size_t i = 0; i < rings.size(); ++i) addRingNormals(Kernels::ringFaces(table_, rings[i]), places[i]);
  if (vertices < steps_.size()) steps_[vertices + 6] = 1;
  largest_ = std::max(largest_, place);
}

void TileImageBuilder::addRingFaces(const Kernels::RingFaces& faces, TileWord place) {
  const TileStep& step = faces.step;
  const TileWord record = texels();
  std::vector<TileWord> corners(at(step.width));
  for (std::int32_t g = 0; g < step.count; ++g) {
    const Far::FacePlaces places = Far::placesOfFace(table_.places, g, step.width);
    for (std::int32_t i = 0; i < step.width; ++i) {
      corners[at(i)] = numbers_[at(faces.kept + places.first + i * places.step)];
    }
    pushHalves(corners);
    image_.words.push_back(0);
    fillTexel();
  }
  const TileWord weight = weights(faces.firstWeight, Far::formWeightCount(step.form, step.width));
  const TileWord stage = texels();
  image_.words.insert(image_.words.end(), {place, weight, stageStride(step), 0});
  pushStep({caseOf(step, TileStages::kept), static_cast<TileWord>(step.count), record,
            static_cast<TileWord>(step.width), stage, 1, 0, 0},
           innerTurns(step, 1));
}

void TileImageBuilder::addRingNormals(const Kernels::RingFaces& faces, TileWord place) {
  const std::int32_t n = faces.step.width;
  const TileWord weights = hexagonWeights();
  const TileWord first = texels();
  for (std::int32_t i = 0; i < faces.step.count * n; ++i) {
    const std::int32_t corner = i % n;
    const std::int32_t face = i - corner;
    const auto own = [&](std::int32_t k) { return place + static_cast<TileWord>(face + (k + n) % n); };
    const auto across = [&](std::int32_t k, std::int32_t j) {
      return numbers_[at(faces.window[face + k % n] / 2 + j * Far::kTileFours)];
    };
    const TileWord hexagon[kHexagon] = {own(corner),       own(corner - 1),       across(corner, 1),
                                        across(corner, 0), across(corner + 1, 2), across(corner + 1, 1)};
    pushHalves(hexagon);
    image_.words.push_back(static_cast<TileWord>(faces.outputs.of(face / n, n) + corner));
    fillTexel();
  }
  pushStep({caseAfter(TileCase::vertexNormals, 0), static_cast<TileWord>(faces.step.count * n), first, kHexagon,
            weights, 0, 0, 1},
           kHexagon);
}

// The weights of both tangents, point by point; zeros where there are none. `first` is the place in `weights` of
// those of the position, which come before.
TileWord TileImageBuilder::tangentWeights(std::span<const float> weights, std::int32_t first, std::int32_t sides) {
  const auto [place, isNew] = tangentWeights_.try_emplace(first, texels());
  if (!isNew) return place->second;
  for (std::int32_t j = 0; j < sides; ++j) {
    for (const std::int32_t row : {1, 2}) {
      const float weight = weights.empty() ? 0.0F : weights[at(first + row * sides + j)];
      image_.words.push_back(std::bit_cast<TileWord>(weight));
    }
  }
  fillTexel();
  return place->second;
}

// Those of kHexagonSpan.
TileWord TileImageBuilder::hexagonWeights() {
  const auto [place, isNew] = tangentWeights_.try_emplace(kHexagonKey, texels());
  if (!isNew) return place->second;
  for (std::size_t j = 0; j < kHexagon; ++j) {
    for (const std::size_t row : {j, j + kHexagon}) {
      image_.words.push_back(std::bit_cast<TileWord>(static_cast<float>(Far::kHexagonSpan[row])));
    }
  }
  fillTexel();
  return place->second;
}

// Points that no tile writes sum shared normals. Some of them at a time make a tile that imports these.
Result<void> TileImageBuilder::addSharedNormals() {
  if (table_.shared.empty()) return {};
  const Far::TileNormals& normals = table_.normals;
  std::vector<NormalSum> sums;
  std::int32_t end = 0;
  const auto flush = [&]() -> Result<void> {
    if (sums.empty()) return {};
    auto added = addWhole([&] { addSharedNormals(sums, end); });
    sums.clear();
    return added;
  };
  std::size_t point = 0;
  for (const Far::SharedPoints::Run& run : table_.shared.back().written) {
    for (std::int32_t i = 0; i < run.count; ++i, ++point) {
      const std::int32_t first = normals.sharedOffsets[point];
      if (!sums.empty() && normals.sharedOffsets[point + 1] - sums.front().first > kSharedAtOnce) {
        if (auto added = flush(); !added) return added;
      }
      end = normals.sharedOffsets[point + 1];
      sums.push_back({first, end - first, static_cast<TileWord>(run.output + i)});
    }
  }
  return flush();
}

// Of normals `sums.front().first` .. `end` of TileNormals::sharedFaces.
void TileImageBuilder::addSharedNormals(std::span<const NormalSum> sums, std::int32_t end) {
  const std::int32_t first = sums.front().first;
  const auto count = static_cast<TileWord>(end - first);
  largest_ = std::max(largest_, count);
  addImportedNormals(std::span(table_.normals.sharedFaces).subspan(at(first), count), 0);
  std::vector<NormalSum> own(sums.begin(), sums.end());
  for (NormalSum& sum : own) sum.first -= first;
  std::vector<TileWord> numbers(count);
  for (TileWord i = 0; i < count; ++i) numbers[i] = i;
  const bool imports = !steps_.empty();
  addSums(own, numbers);
  if (imports) steps_[steps_.size() - 2] = 1;
  closeTile(0, 0);
}

}  // namespace honeycomb::Osd
