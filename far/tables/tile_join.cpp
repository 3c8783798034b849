#include "far/tables/tile_join.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "far/base/index.h"
#include "far/base/parallel.h"

namespace honeycomb::Far {

namespace {

/// The arrays that are joined; those from `ranges` on are the normals', from `limitRanges` on the limits'.
struct Joined {
  enum Array : std::size_t {
    tiles,
    steps,
    stages,
    imports,
    indices,
    rows,
    outputs,
    written,
    ranges,
    normalImports,
    frames,
    corners,
    firstFaces,
    faces,
    born,
    limitRanges,
    vertexFrames,
    vertexIndices,
    ringRanges,
    rings,
    windows,
    count
  };
};

/// Calls visit(which, part's array, table's array) for each.
template <class Visit>
void forArrays(TileParts& part, TileTable& table, const Visit& visit) {
  visit(Joined::tiles, part.tiles, table.tiles);
  visit(Joined::steps, part.steps, table.steps);
  visit(Joined::stages, part.stages, table.stages);
  visit(Joined::imports, part.imports, table.imports);
  visit(Joined::indices, part.indices, table.indices);
  visit(Joined::rows, part.rows, table.rows);
  visit(Joined::outputs, part.outputs, table.outputs);
  visit(Joined::written, part.written, table.written);
  visit(Joined::ranges, part.normals.tiles, table.normals.tiles);
  visit(Joined::normalImports, part.normals.imports, table.normals.imports);
  visit(Joined::frames, part.normals.frames, table.normals.frames);
  visit(Joined::corners, part.normals.indices, table.normals.indices);
  visit(Joined::firstFaces, part.normals.firstFace, table.normals.firstFace);
  visit(Joined::faces, part.normals.faces, table.normals.faces);
  visit(Joined::born, part.normals.born, table.normals.born);
  visit(Joined::limitRanges, part.limits.tiles, table.limits.tiles);
  visit(Joined::vertexFrames, part.limits.frames, table.limits.frames);
  visit(Joined::vertexIndices, part.limits.indices, table.limits.indices);
  visit(Joined::ringRanges, part.limits.ringTiles, table.limits.ringTiles);
  visit(Joined::rings, part.limits.rings, table.limits.rings);
  visit(Joined::windows, part.limits.windows, table.limits.windows);
}

/// Entries of each array before a part.
using Bases = std::array<std::int64_t, Joined::count>;

/// Moves on what counts from a part's beginning.
class PlaceShift {
 public:
  PlaceShift(const Bases& base, TileOrder order)
      : base_(base), outputs_(order == TileOrder::tiles ? Joined::written : Joined::outputs) {}

  void move(TileParts& part) const {
    for (Tile& tile : part.tiles) {
      add(tile.firstImport, Joined::imports);
      add(tile.firstStep, Joined::steps);
    }
    for (TileStep& step : part.steps) {
      add(step.firstIndex, Joined::indices);
      add(step.firstStage, Joined::stages);
      add(step.firstRow, Joined::rows);
    }
    for (TileStage& stage : part.stages) {
      if (stage.firstOutput >= 0) add(stage.firstOutput, outputs_);
    }
    move(part.normals);
    move(part.limits);
  }

 private:
  void add(std::int32_t& place, Joined::Array array) const { place += static_cast<std::int32_t>(base_[array]); }

  void move(TileNormals& part) const {
    for (TileNormalRange& range : part.tiles) {
      add(range.firstImport, Joined::normalImports);
      add(range.firstFrames, Joined::frames);
    }
    for (TileFrames& frames : part.frames) add(frames.firstIndex, Joined::corners);
    for (std::int32_t& first : part.firstFace) {
      if (first >= 0) add(first, Joined::faces);
    }
  }

  void move(TileLimits& part) const {
    for (TileLimits::Range& range : part.tiles) add(range.first, Joined::vertexFrames);
    for (TileLimits::Range& range : part.ringTiles) add(range.first, Joined::rings);
    for (TileRings& rings : part.rings) {
      add(rings.step, Joined::steps);
      add(rings.firstIndex, Joined::windows);
    }
    for (TileVertexFrames& frames : part.frames) {
      add(frames.firstIndex, Joined::vertexIndices);
      add(frames.firstOutput, outputs_);
    }
  }

  const Bases& base_;
  Joined::Array outputs_;
};

}  // namespace

Result<void> joinTiles(std::vector<TileParts>& parts, TileTable& table, std::int64_t most) {
  std::vector<Bases> bases(parts.size());
  Bases next{};
  for (std::size_t p = 0; p < parts.size(); ++p) {
    bases[p] = next;
    forArrays(parts[p], table, [&](Joined::Array which, const auto& from, const auto&) {
      next[which] += static_cast<std::int64_t>(from.size());
    });
  }
  if (const std::int64_t longest = std::ranges::max(next); longest > most) {
    return fail(ErrorCode::tooLarge, fmt::format("the tiles would have {} indices, and {} can be told apart; use fewer "
                                                 "levels, or evaluate level by level",
                                                 longest, most));
  }
  TileParts none;
  forArrays(none, table, [&](Joined::Array which, const auto&, auto& to) { to.resize(at(next[which])); });
  const auto move = [&](std::int64_t p) {
    TileParts& part = parts[at(p)];
    PlaceShift(bases[at(p)], table.order).move(part);
    forArrays(part, table, [&](Joined::Array which, auto& from, auto& to) {
      std::ranges::copy(from, to.begin() + bases[at(p)][which]);
      from = {};
    });
  };
  Parallel::forEach(0, static_cast<std::int64_t>(parts.size()), move, 1);
  return {};
}

}  // namespace honeycomb::Far
