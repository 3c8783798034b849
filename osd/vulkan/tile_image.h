#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "far/base/result.h"
#include "far/tables/tile_table.h"

namespace honeycomb::Osd {

/// A word of the tile kernels' table.
using TileWord = std::uint32_t;
constexpr std::size_t kTexelWords = 4;

/// Some tiles of a TileTable for one wanted level, as shaders/tile.glsl reads them: texels of four words, whose places
/// count texels from the first.
///     tile     first import, imports, first step, steps                    one texel each, behind all else
///     imports  points of the root level; with the highest bit: shared points
///     step     case, faces, first record, width | first stage, kept stages, 1 where a new level begins, 1
///              where a stage is written behind those kept
///     stage    first point of the tile's own that is kept, first weight, 0, 0
///     record   of faces and rows: shaders/tile_faces.glsl and tile_rows.glsl draw them
///     weights  of a circulant's form or of dense rows, each from a texel on
struct TileImage {
  std::vector<TileWord> words;
  std::uint32_t firstTile = 0;
  std::uint32_t tileCount = 0;
  std::uint32_t cases = 0;  ///< bit k: there are steps of case k
  bool pairs = true;        ///< each written face of an even number of sides begins at an even point
};

/// Packs tiles until an image is full.
class TileImageBuilder {
 public:
  /// For level `level` behind the tiles' root level; an image has at most `mostTexels`.
  TileImageBuilder(const Far::TileTable& table, std::int32_t level, std::uint64_t mostTexels)
      : table_(table), level_(level), mostTexels_(mostTexels) {}

  /// All of `tiles`, in as few images as hold them. tooLarge where a tile alone passes an image. Linear.
  Result<std::vector<TileImage>> build(std::span<const std::int32_t> tiles);

 private:
  TileWord texels() const { return static_cast<TileWord>(image_.words.size() / kTexelWords); }
  void fillTexel();
  void finish(std::vector<TileImage>& images);
  void numberPoints(const Far::Tile& tile);
  TileWord ownNumber(Far::TilePoint point) const { return numbers_[point / 2U]; }
  void addTile(const Far::Tile& tile);
  void addImports(const Far::Tile& tile);
  std::optional<std::array<TileWord, 2 * kTexelWords>> step(const Far::TileStep& step);
  TileWord addRecords(const Far::TileStep& step, bool written, std::int32_t stage);
  TileWord addRows(const Far::TileStep& step, bool written);
  TileWord addStages(const Far::TileStep& step, std::int32_t stages);
  TileWord weights(std::int32_t first, std::int32_t count);
  TileWord output(const Far::TileStep& step, std::int32_t stage, std::int32_t item) const;

  const Far::TileTable& table_;
  std::int32_t level_;
  std::uint64_t mostTexels_;
  TileImage image_;
  std::vector<TileWord> tiles_;
  std::map<std::int32_t, TileWord> weights_;
  std::vector<TileWord> numbers_;  ///< of the tile's points in the image
};

}  // namespace honeycomb::Osd
