#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <vector>

#include "far/base/result.h"
#include "far/tables/tile_table.h"
#include "osd/tile_kernels.h"
#include "osd/tile_normal_kernels.h"
#include "osd/vulkan/tile_cases.h"

namespace honeycomb::Osd {

/// A word of the tile kernels' table.
using TileWord = std::uint32_t;
constexpr std::size_t kTexelWords = 4;

/// Some tiles of a TileTable for one wanted level, as shaders/tile.glsl reads them: texels of four words, whose places
/// count texels from the first.
///     tile     first import, imports, first step, steps                    one texel each, behind all else
///     imports  points of the root level; with the highest bit: shared points
///     step     case, faces, first record, width | first stage, kept stages, 1 where what the steps before wrote is
///              read, how a stage is written: 0 none is, 1 the one behind those kept, 2 the last of these
///              of normals: case, items, first record, width | first weight, first kept normal or neighbours, ..
///     stage    first point of the tile's own that is kept, first weight, from the former to the next stage's, 0
///     record   of faces, rows and normals: shaders/tile_faces.glsl, tile_rows.glsl and tile_normals.glsl draw them
///     weights  of a circulant's form or of dense rows, or of a normal's tangents, each from a texel on
struct TileImage {
  std::vector<TileWord> words;
  std::uint32_t firstTile = 0;
  std::uint32_t tileCount = 0;
  std::uint64_t cases = 0;  ///< bit k: there are steps of case k
  bool pairs = true;        ///< each written face of an even number of sides begins at an even point
  bool fours = true;        ///< and each of a multiple of four sides at such a point
  bool sameWeights = true;  ///< faces have the same weights at all their stages
  std::uint64_t turns = 0;  ///< the most that one tile's loops take together, inner ones included, where invocations
                            ///< of a workgroup go through all branches together
};

/// Packs tiles until an image is full.
class TileImageBuilder {
 public:
  /// For level `level` behind the tiles' root level, with normals of the table's kind or none; an image has at most
  /// `mostTexels`, and workgroups of `invocations` run it.
  TileImageBuilder(const Far::TileTable& table, std::int32_t level, Far::TileNormalKind normals,
                   std::uint64_t mostTexels, std::uint32_t invocations)
      : table_(table),
        level_(level),
        last_(normals == Far::TileNormalKind::exact ? level + 1 : level),
        normals_(normals),
        mostTexels_(mostTexels),
        invocations_(invocations) {}

  /// All of `tiles`, and fast normals of the points that no tile writes as tiles of their own, in as few images as hold
  /// them. tooLarge where a tile alone passes an image. Linear.
  Result<std::vector<TileImage>> build(std::span<const std::int32_t> tiles);

  /// The most points and normals that one of the tiles keeps.
  std::uint32_t largestTile() const { return largest_; }

 private:
  using StepWords = std::array<TileWord, 2 * kTexelWords>;
  /// A point that sums normals: these stand at `first` in the list it belongs to.
  struct NormalSum {
    std::int32_t first = 0;
    std::int32_t count = 0;
    TileWord output = 0;
  };

  Result<void> addWhole(const std::function<void()>& add);
  void finish();
  void addTile(std::int32_t number);
  void numberPoints(const Far::Tile& tile);
  /// The first even number from `number` on.
  static constexpr TileWord evenFrom(TileWord number) { return number + number % 2; }
  /// From the points that a stage keeps to those of the next.
  static TileWord stageStride(const Far::TileStep& step);
  void numberStage(const Far::TileStep& step, std::int32_t firstPoint, TileWord number);
  TileWord ownNumber(Far::TilePoint point) const { return numbers_[point / 2U]; }
  void addImports(const Far::Tile& tile);
  void closeTile(TileWord firstImport, std::int32_t imports);
  void addStep(const Far::TileStep& step);
  void pushStep(StepWords words, std::uint64_t innerTurns);
  std::uint64_t turnsOver(std::uint64_t items) const { return (items + invocations_ - 1) / invocations_; }
  std::uint64_t innerTurns(const Far::TileStep& step, std::int32_t stages) const;
  TileWord addRecords(const Far::TileStep& step, bool written);
  TileWord addRows(const Far::TileStep& step, bool written);
  TileWord addStages(const Far::TileStep& step, std::int32_t stages);
  TileWord weights(std::int32_t first, std::int32_t count);
  Kernels::Outputs outputs(const Far::TileStep& step) const;

  // Normals: tile_normal_image.cpp.
  void addFastNormals(std::int32_t number);
  void addImportedNormals(std::span<const std::int32_t> normals, TileWord place);
  void addFaceNormals(const Far::TileFrames& frames, const Far::TileCorners& read, TileWord place);
  void addCornerNormals(const Far::TileStep& step, const Far::TilePoint* faces);
  void addSummedNormals(const Far::TileStep& step, const Far::TilePoint* faces);
  void addSums(std::span<const NormalSum> sums, std::span<const TileWord> normals);
  void addExactNormals(std::int32_t number);
  void addRings(std::span<const Far::TileRings> rings);
  void addRingFaces(const Kernels::RingFaces& faces, TileWord place);
  void addRingNormals(const Kernels::RingFaces& faces, TileWord place);
  TileWord tangentWeights(std::span<const float> weights, std::int32_t first, std::int32_t sides);
  TileWord hexagonWeights();
  Result<void> addSharedNormals();
  void addSharedNormals(std::span<const NormalSum> sums, std::int32_t end);

  // The image.
  TileWord texels() const { return static_cast<TileWord>(image_.words.size() / kTexelWords); }
  void fillTexel();
  void pushHalves(std::span<const TileWord> numbers);

  const Far::TileTable& table_;
  std::int32_t level_;
  std::int32_t last_;  ///< the level wanted, or the one behind it where exact normals read that
  Far::TileNormalKind normals_;
  std::uint64_t mostTexels_;
  std::uint32_t invocations_;
  std::uint32_t largest_ = 1;
  std::vector<TileImage> images_;
  TileImage image_;
  std::vector<TileWord> tiles_;
  std::map<std::int32_t, TileWord> weights_;         ///< where the image has those of the table
  std::map<std::int32_t, TileWord> tangentWeights_;  ///< and those of normals
  std::vector<TileWord> steps_;                      ///< of the tile
  std::vector<TileWord> numbers_;                    ///< of the tile's points in the image
  TileWord pointCount_ = 0;                          ///< behind the last of these
  std::uint64_t turns_ = 0;                          ///< of the tile's loops
  TileWord mostSteps_ = 0;                           ///< of a tile
  TileWord firstNormal_ = 0;                         ///< the tile's own normals stand behind its points
};

}  // namespace honeycomb::Osd
