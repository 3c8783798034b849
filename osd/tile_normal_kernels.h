#pragma once

#include <cstdint>
#include <span>

#include "far/base/index.h"
#include "far/tables/tile_table.h"
#include "osd/tile_kernels.h"

/// Normals of tiles in plain loops, behind the points of the same tile.
namespace honeycomb::Osd::Kernels {

/// What a tile's normals are found from and where they go.
template <class Real>
struct NormalViews {
  View<const Real> shared;  ///< shared normals
  View<Real> target;        ///< normals of the last level
  Real* scratch;            ///< the tile's own face normals, kTileStride apart
  Real* stream = nullptr;   ///< as TileViews::stream
  View<Real> points = {};   ///< points of the last level, three numbers each: those that TileViews::later tells leave
                            ///< with their normals. None: all have been written
};

/// The normals of `frames`, to `to` and behind it. w: their weights, as FrameBatch has them.
template <class Real>
void frameNormals(const Far::TileFrames& frames, const Real* w, const Far::TileCorners& corners, const Real* points,
                  View<Real> to) {
  const std::int32_t n = frames.sides;
  const View<const Real> own = byTilePoint(points);
  Far::TilePoint room[Far::kLargestCirculant] = {};
  for (std::int32_t g = 0; g < frames.count; ++g) {
    const Far::TilePoint* index = corners.of(g, room);
    const auto t1 = blockedSum<3>(w + n, index, n, own);
    const auto t2 = blockedSum<3>(w + 2 * std::int64_t{n}, index, n, own);
    store(unitNormal(t1, t2), to.point(g));
  }
}

/// Calls visit(frames, their corners, the tile's number of the first normal, step) for the faces whose normals tile
/// `number` finds. step: of TileTable::steps, what reads the same corners (TileBorn), or -1; frames.firstIndex counts
/// where it is -1 alone.
template <class Visit>
void forTileFrames(const Far::TileTable& table, std::int32_t number, const Visit& visit) {
  const Far::TileNormals& normals = table.normals;
  const Far::TileNormalRange& range = normals.tiles[at(number)];
  std::int32_t next = range.importCount;
  for (const Far::TileFrames& frames :
       std::span(normals.frames).subspan(at(range.firstFrames), at(range.framesCount))) {
    visit(frames, Far::TileCorners{normals.indices.data() + frames.firstIndex, frames.sides, false}, next, -1);
    next += frames.count;
  }
  const Far::Tile& tile = table.tiles[at(number)];
  for (std::int32_t s = tile.firstStep; s < tile.firstStep + tile.stepCount; ++s) {
    const Far::TileBorn& born = normals.born[at(s)];
    if (born.firstNormal < 0) continue;
    const Far::TileStep& step = table.steps[at(s)];
    visit(Far::TileFrames{step.width, step.count, 0, born.firstWeight}, cornersOf(table, step), born.firstNormal, s);
  }
}

/// The normals of the faces that a tile knows.
template <class Real>
void tileFaceNormals(const Far::TileTable& table, std::int32_t number, const Real* points,
                     const NormalViews<Real>& views) {
  const Far::TileNormals& normals = table.normals;
  const Far::TileNormalRange& range = normals.tiles[at(number)];
  const View<Real> own{views.scratch, kTileStride};
  for (std::int32_t i = 0; i < range.importCount; ++i) {
    store(load<3>(views.shared.point(normals.imports[at(range.firstImport + i)])), own.point(i));
  }
  const Real* weights = normals.weightsAs<Real>().data();
  forTileFrames(table, number,
                [&](const Far::TileFrames& frames, const Far::TileCorners& corners, std::int32_t first, std::int32_t) {
                  frameNormals(frames, weights + frames.firstWeight, corners, points, {own.point(first), own.stride});
                });
}

/// The normals of a step's outputs of the last level.
template <class Real>
void tileVertexNormals(const Far::TileTable& table, std::int32_t number, const NormalViews<Real>& views) {
  const Far::TileNormals& normals = table.normals;
  const Far::TileStep& step = table.steps[at(number)];
  const Outputs outputs = lastOutputs(table, step);
  const View<const Real> own = byTilePoint<Real>(views.scratch);
  const Far::TilePoint* face = normals.faces.data() + normals.firstFace[at(number)];
  if (step.kind != Far::TileStep::Kind::circulant) {
    for (std::int32_t r = 0; r < step.count; face += 1 + face[0], ++r) {
      store(normalSum(face + 1, face[0], own), views.target.point(outputs.of(r, 1)));
    }
    return;
  }
  const std::int32_t neighbours = normals.neighbours;
  for (std::int32_t g = 0; g < step.count; ++g) {
    const auto twice = load<3>(own.point(face[0])) + load<3>(own.point(face[0]));
    ++face;
    const std::int32_t first = outputs.of(g, step.width);
    for (std::int32_t i = 0; i < step.width; ++i) {
      auto sum = twice;
      for (std::int32_t j = 0; j < neighbours; ++j) sum = sum + load<3>(own.point(*face++));
      store(unit(sum), views.target.point(first + i));
    }
  }
}

/// Faces whose vertices' exact normals are found round them.
struct RingFaces {
  const Far::TileStep& step;
  std::int32_t kept;             ///< the tile's own point of the last level that is their first
  std::int32_t firstWeight;      ///< of the form of the level behind
  const Far::TilePoint* window;  ///< as TileLimits::windows
  Outputs outputs;
};

inline RingFaces ringFaces(const Far::TileTable& table, const Far::TileRings& rings) {
  const Far::TileStep& step = table.steps[at(rings.step)];
  const Far::TileStage& stage = table.stages[at(step.firstStage + table.lastLevel - step.level)];
  return {step, stage.firstPoint, rings.firstWeight, table.limits.windows.data() + rings.firstIndex,
          outputsFrom(table, stage.firstOutput)};
}

/// The normals of the vertices of such faces, N sides or any number if 0.
template <int N, class Real>
void ringNormals(const Far::TileTable& table, const RingFaces& faces, const Real* points,
                 const NormalViews<Real>& views) {
  constexpr int kMost = N > 0 ? N : Far::kLargestCirculant;
  const std::int32_t n = N > 0 ? N : faces.step.width;
  const Real* weights = table.weightsAs<Real>().data() + faces.firstWeight;
  const Far::TilePoint* window = faces.window;
  for (std::int32_t g = 0; g < faces.step.count; ++g, window += n) {
    const Far::FacePlaces places = Far::placesOfFace(table.places, g, n);
    const View<const Real> corners{points + std::int64_t{kTileStride} * (faces.kept + places.first),
                                   std::int64_t{kTileStride} * places.step};
    std::array<Real, 3> p[kMost];
    for (std::int32_t i = 0; i < n; ++i) p[i] = load<3>(corners.point(i));
    const std::int32_t output = faces.outputs.of(g, n);
    if (views.points.data != nullptr) {
      for (std::int32_t i = 0; i < n; ++i) store(p[i], views.points.point(output + i));
    }
    Real behind[3 * kMost];
    circulantFace<N>(faces.step.form, weights, p, n, View<Real>{behind, 3}, 0);
    const auto own = [&](std::int32_t i) { return load<3>(behind + 3 * (i < 0 ? i + n : i)); };
    const auto across = [&](std::int32_t i, std::int32_t k) {
      const View<const Real> three{byTilePoint(points).point(window[i < n ? i : 0]), kTileStride * Far::kTileFours};
      return load<3>(three.point(k));
    };
    for (std::int32_t i = 0; i < n; ++i) {
      const std::array<Real, 3> hexagon[6] = {own(i),       own(i - 1),       across(i, 1),
                                              across(i, 0), across(i + 1, 2), across(i + 1, 1)};
      const auto a = ((hexagon[0] + hexagon[1]) - hexagon[3]) - hexagon[4];
      const auto b = ((hexagon[1] + hexagon[2]) - hexagon[4]) - hexagon[5];
      store(unitNormal(a, b), views.target.point(output + i));
    }
  }
}

/// The exact normals of the points that a tile writes.
template <class Real>
void evaluateTileLimits(const Far::TileTable& table, std::int32_t number, const Real* points,
                        const NormalViews<Real>& views) {
  const Far::TileLimits& limits = table.limits;
  const Far::TileLimits::Range& range = limits.tiles[at(number)];
  const View<const Real> own = byTilePoint(points);
  for (const Far::TileVertexFrames& frames : std::span(limits.frames).subspan(at(range.first), at(range.count))) {
    const std::int32_t n = frames.sides;
    const Outputs outputs = outputsFrom(table, frames.firstOutput);
    const Real* w = limits.weightsAs<Real>().data() + frames.firstWeight;
    const Far::TilePoint* index = limits.indices.data() + frames.firstIndex;
    for (std::int32_t g = 0; g < frames.count; ++g) {
      const std::int32_t first = outputs.of(g, frames.each);
      for (std::int32_t i = 0; i < frames.each; ++i, index += n) {
        const auto t1 = blockedSum<3>(w + n, index, n, own);
        const auto t2 = blockedSum<3>(w + 2 * std::int64_t{n}, index, n, own);
        store(unitNormal(t1, t2), views.target.point(first + i));
      }
    }
  }
  const Far::TileLimits::Range& rings = limits.ringTiles[at(number)];
  for (const Far::TileRings& some : std::span(limits.rings).subspan(at(rings.first), at(rings.count))) {
    const RingFaces faces = ringFaces(table, some);
    forSides(faces.step.width, [&](auto sides) { ringNormals<decltype(sides)::value>(table, faces, points, views); });
  }
}

template <class Real>
void evaluateTileNormals(const Far::TileTable& table, std::int32_t number, const Real* points,
                         const NormalViews<Real>& views) {
  if (table.normalKind == Far::TileNormalKind::exact) return evaluateTileLimits(table, number, points, views);
  tileFaceNormals(table, number, points, views);
  const Far::Tile& tile = table.tiles[at(number)];
  for (std::int32_t s = tile.firstStep; s < tile.firstStep + tile.stepCount; ++s) {
    if (table.normals.firstFace[at(s)] >= 0) tileVertexNormals(table, s, views);
  }
}

}  // namespace honeycomb::Osd::Kernels
