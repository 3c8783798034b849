#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "far/base/array.h"
#include "far/base/result.h"
#include "far/tables/refinement.h"

namespace honeycomb::Far {

/// The order in which a TileTable writes the points of a level.
enum class TileOrder : std::uint8_t {
  levels,  ///< that of the level tables, so that the level's index buffers fit
  tiles    ///< tile after tile, each a contiguous range: TileTable::written tells which point went where
};

/// Which unit normals of the last level's vertices tiles find besides its points.
enum class TileNormalKind : std::uint8_t {
  none,
  fast,  ///< of a few faces round a vertex: see NormalRule
  exact  ///< of the refinement's limits (RefineOptions::limits), the bits of CpuEvaluator::vertexLimits; slower
};

/// How the points of a step's faces stand in a tile, faces a b c .. of points 0 .. n:
///     faces    a0 a1 .. an  b0 b1 .. bn  c0 ..
///     fours    an bn cn dn  a0 b0 c0 d0  ..  an bn cn dn  en fn -- --  e0 f0 -- --  ..  en fn -- --
/// Of fours the last point stands in front once more, so that each point has the one before it in front; and there is
/// room for four faces where fewer are left over.
enum class TilePlaces : std::uint8_t {
  faces = 0,
  fours = 2  ///< four faces' points are a cache line, which vectors write as they come, and a number stands for a point
             ///< and the one before it: what TileEvaluator is fastest with
};

/// Faces that stand point by point together.
constexpr std::int32_t kTileFours = 4;
/// Where the points of a face stand, counted from the step's first: the first of them, and from one to the next.
struct FacePlaces {
  std::int32_t first = 0;
  std::int32_t step = 1;
};
/// Of face `face` with `sides` points; as fours its last point stands at first - step, too.
constexpr FacePlaces placesOfFace(TilePlaces places, std::int32_t face, std::int32_t sides) {
  if (places == TilePlaces::faces) return {face * sides, 1};
  const std::int32_t among = face % kTileFours;
  return {(face - among) * (sides + 1) + among + kTileFours, kTileFours};
}
/// Room for the points of `count` faces.
constexpr std::int64_t roomOfFaces(TilePlaces places, std::int64_t count, std::int32_t sides) {
  if (places == TilePlaces::faces) return count * sides;
  return (count + kTileFours - 1) / kTileFours * kTileFours * (sides + 1);
}

/// What tiles are to give, and how large they are.
struct TileOptions {
  std::int32_t level = 0;             ///< the last level to evaluate; 0: the refinement's last
  std::int32_t scratchPoints = 8192;  ///< points a tile keeps at once, about, 16 bytes each in single precision: what
                                      ///< half a second-level cache holds; 64 .. 32768
  std::int32_t fewestTiles = 1;       ///< at least so many, where each still keeps 4096 points: several a thread, so
                                      ///< that all are busy to the end (Osd::cpuTileOptions); from 1
  std::int32_t workers = 1;           ///< threads that share the tiles: where it can be, as many tiles for each; from 1
  TileOrder order = TileOrder::levels;
  TileNormalKind normals = TileNormalKind::none;
  TilePlaces places = TilePlaces::faces;
};

/// Points of a tile are numbered from 0 over all of its levels; kept is twice the number, so that sixteen bits tell
/// 32,768 points apart and a point of four floats stands at 8 bytes times what is kept, which is an address by itself.
using TilePoint = std::uint16_t;
/// Points of a tile, of all its levels together.
constexpr std::int32_t kMostTilePoints = 32768;
/// What is kept of a number.
constexpr TilePoint tilePoint(std::int32_t number) {
  return static_cast<TilePoint>(2 * number);
}

/// What the points of a step of a tile go through at one level: the arithmetic of a batch of that level's table.
struct TileStage {
  std::int32_t firstWeight = 0;   ///< in TileTable::weights: the form of a circulant, the weights of dense rows
  std::int32_t firstPoint = -1;   ///< the tile's own number of the first output, the others stand behind it as
                                  ///< TileStep::placesIn tells; -1: nobody in the tile reads them
  std::int32_t firstOutput = -1;  ///< where they go when this level is the wanted one; -1: another tile writes them.
                                  ///< TileOrder::levels: in TileTable::outputs, one entry a face or row, its first
                                  ///< point; TileOrder::tiles: the first point, the others follow
};

/// Faces (or rows) of a tile that are born at the same level and live equally long. A face evolves alone: its points
/// at a level are one circulant matrix times its points at the level before, so it is gathered once, at birth, and
/// its points at all later levels follow without reading anything.
///     indices   count x sides (circulant: TileCorners) or count x width (dense) own points of the level before birth
///     loose     rows firstRow .. firstRow + count - 1, their entries one after the other from firstIndex
struct TileStep {
  /// The batch whose arithmetic it has.
  enum class Kind : std::uint8_t { circulant, dense, loose };
  Kind kind = Kind::circulant;
  CirculantForm form = CirculantForm::direct;  ///< of a circulant, at all stages
  std::uint8_t level = 0;                      ///< the level of birth; stage s belongs to level + s
  std::uint8_t stageCount = 1;                 ///< 1 for rows
  bool sameWeights = true;                     ///< of all stages
  bool pairs = false;                          ///< its indices are those of pairs: TileCorners
  std::int32_t width = 0;                      ///< sides, or entries a dense row
  std::int32_t count = 0;                      ///< faces or rows
  std::int32_t firstIndex = 0;
  std::int32_t firstStage = 0;
  std::int32_t firstRow = 0;

  /// Points a face; a row is one.
  std::int32_t pointsEach() const { return kind == Kind::circulant ? width : 1; }
  /// How its points stand in a tile whose faces stand as `faces` tells: rows always one behind the other.
  TilePlaces placesIn(TilePlaces faces) const { return kind == Kind::circulant ? faces : TilePlaces::faces; }
};

/// The own points that the faces of a step read at birth. The corners of what becomes of a vertex are neighbours in
/// the faces round it, two of each: c_0 and the one before it in its face, which is c_1, c_2 and so on. Where these
/// stand as TilePlaces::fours one number, that of c_1, stands for both (`pairs`).
struct TileCorners {
  const TilePoint* indices = nullptr;
  std::int32_t sides = 0;
  bool pairs = false;

  /// Numbers a face.
  std::int32_t each() const { return pairs ? sides / 2 : sides; }
  /// The corners of face `face`; `room`: for `sides` of them, used where the table doesn't have them as they are.
  const TilePoint* of(std::int32_t face, TilePoint* room) const {
    const TilePoint* first = indices + std::ptrdiff_t{face} * each();
    if (!pairs) return first;
    for (std::int32_t i = 0; i < sides; ++i) {
      room[i] = static_cast<TilePoint>(first[i / 2] + (i % 2 == 0 ? tilePoint(kTileFours) : 0));
    }
    return room;
  }
};

/// A loose row of a tile.
struct TileRow {
  std::int32_t firstWeight = 0;
  std::int32_t entries = 0;
};

/// A piece of the mesh that is evaluated without looking at another: its faces with all that descends from them, and
/// the few faces outside whose points they read.
struct Tile {
  std::int32_t firstImport = 0;  ///< points read from the root level and from the shared points: own numbers 0 ..
  std::int32_t importCount = 0;
  std::int32_t firstStep = 0;
  std::int32_t stepCount = 0;
  std::int32_t pointCount = 0;  ///< own points, imports included
};

/// Faces and rows too large for any tile, and what they read, level after level in compact numbers: evaluated before
/// the tiles, which import their points.
struct SharedPoints {
  /// Points of this set that stand for points of the level: set point `point` + i is output `output` + i.
  struct Run {
    std::int32_t point = 0;
    std::int32_t output = 0;
    std::int32_t count = 0;
  };
  LevelTable table;             ///< from the points of the set before (the root level's at first)
  std::int32_t firstPoint = 0;  ///< number of the set's first point among those of all sets
  Array<Run> written;           ///< the points that no tile writes
};

/// Faces of a tile whose normals are found alike: FrameBatch on own points.
struct TileFrames {
  std::int32_t sides = 0;
  std::int32_t count = 0;
  std::int32_t firstIndex = 0;   ///< in TileNormals::indices, count x sides
  std::int32_t firstWeight = 0;  ///< in TileNormals::weights: as FrameBatch has them, a and b alone are used
};

/// The normals of all faces of a step, which are found from the points that it reads anyway: FrameBatch on these.
struct TileBorn {
  std::int32_t firstNormal = -1;  ///< the tile's own number of the first face's, the others follow; -1: none
  std::int32_t firstWeight = 0;   ///< in TileNormals::weights: as FrameBatch has them, a and b alone are used
};

/// The face normals a tile knows, numbered from 0: those imported, those of its frames, those of its steps' faces.
struct TileNormalRange {
  std::int32_t firstImport = 0;
  std::int32_t importCount = 0;
  std::int32_t firstFrames = 0;
  std::int32_t framesCount = 0;
  std::int32_t normalCount = 0;
};

/// What the fast normals of the last level are made of, tile by tile: see NormalRule.
struct TileNormals {
  Array<TileNormalRange> tiles;  ///< one a tile
  Array<std::int32_t> imports;   ///< shared normals
  Array<TileFrames> frames;
  Array<TilePoint> indices;
  /// Per step that writes the last level: where its outputs begin in `faces`; -1 of others.
  ///     circulant   for each face its own normal, then `neighbours` normals a corner
  ///     rows        for each row how many normals, then these
  /// Normals are kept as points are: twice their number.
  Array<std::int32_t> firstFace;
  Array<TilePoint> faces;
  Array<TileBorn> born;  ///< one a step
  std::int32_t neighbours = 1;
  Array<double> weights;
  Array<float> weightsSingle;
  /// Normals of faces born before the tiles' root level, from the points of levels 0 .. rootLevel; and of faces too
  /// large for a tile, from the root's points and from shared points (as TileTable::imports numbers them). Elements:
  /// shared normals. One a level; none if the table was built without normals.
  std::vector<LimitRows> shared;
  std::int32_t sharedCount = 0;
  /// Per point of the last level that no tile writes (SharedPoints::written, run after run): the shared normals it
  /// sums.
  Array<std::int32_t> sharedOffsets;
  Array<std::int32_t> sharedFaces;
  std::int32_t largestTile = 0;  ///< the most normals of a tile

  template <class Real>
  std::span<const Real> weightsAs() const;
  std::int64_t byteCount() const;
};

template <>
inline std::span<const double> TileNormals::weightsAs<double>() const {
  return weights;
}
template <>
inline std::span<const float> TileNormals::weightsAs<float>() const {
  return weightsSingle;
}

/// Vertices that a tile writes at the last level and whose exact normals are found alike: FrameBatch on own points, of
/// the last level or the one behind it.
struct TileVertexFrames {
  std::int32_t sides = 0;        ///< points a vertex reads; 0: central control vertices, which have the zero vector
  std::int32_t count = 0;        ///< faces with all their points, or single points
  std::int32_t each = 1;         ///< points of a face, one behind the other
  std::int32_t firstIndex = 0;   ///< in TileLimits::indices, count x each x sides
  std::int32_t firstWeight = 0;  ///< in TileLimits::weights: as FrameBatch has them, a and b alone are used
  std::int32_t firstOutput = 0;  ///< where they go, as TileStage::firstOutput
};

/// Faces that are a tile's own and whose vertices of the last level have exact normals of one shape: vertex i of a face
/// becomes a hexagon between the face itself, the neighbour across the edge before and the one across the edge behind,
/// two points of each. So that a face's points of the level behind are found in passing, and of each neighbour three
/// points in a row are read, which serve both vertices of the edge:
///     hexagon i   own i, own i - 1, second and first of neighbour i, third and second of neighbour i + 1
/// Its normal is A x B of Far::kHexagonSpan.
struct TileRings {
  std::int32_t step = 0;         ///< in TileTable::steps: the faces, whose points of the last level the tile keeps
  std::int32_t firstWeight = 0;  ///< in TileTable::weights: their form at the level behind
  std::int32_t firstIndex = 0;   ///< in TileLimits::windows, count x sides: the first of the neighbour's three points
};

/// What the exact normals of the last level are made of: LimitTable, tile by tile. The tiles then make the points of
/// the level behind the last one, too.
struct TileLimits {
  /// A tile's frames, or its rings.
  struct Range {
    std::int32_t first = 0;
    std::int32_t count = 0;
  };
  Array<Range> tiles;  ///< one a tile: its frames
  Array<TileVertexFrames> frames;
  Array<TilePoint> indices;
  Array<Range> ringTiles;  ///< one a tile: its rings
  Array<TileRings> rings;
  Array<TilePoint> windows;
  Array<double> weights;
  Array<float> weightsSingle;
  /// Of points that no tile writes, and of vertices that read too many for a tile; elements: where they go. They read
  /// shared points, of whichever level, as TileTable::imports numbers them.
  LimitRows shared;

  template <class Real>
  std::span<const Real> weightsAs() const;
  std::int64_t byteCount() const;
};

template <>
inline std::span<const double> TileLimits::weightsAs<double>() const {
  return weights;
}
template <>
inline std::span<const float> TileLimits::weightsAs<float>() const {
  return weightsSingle;
}

/// A refinement cut into tiles, for evaluators: same points, same bits as level after level, but each tile's points
/// stay in a cache, only the wanted level is written, and nobody waits for anybody. Compiled from the level tables of
/// any chain of schemes. Levels up to `rootLevel` are evaluated one after the other where the mesh has more levels than
/// a tile can hold.
struct TileTable {
  std::int32_t rootLevel = 0;
  std::int32_t lastLevel = 0;
  TileOrder order = TileOrder::levels;
  TilePlaces places = TilePlaces::faces;
  std::int32_t rootPoints = 0;     ///< points of the root level
  Array<std::int32_t> pointCount;  ///< of levels 0 .. lastLevel: what the level tables read and make
  Array<Tile> tiles;
  Array<TileStep> steps;
  Array<TileStage> stages;
  Array<std::int32_t> imports;  ///< points of the root level, or rootPoints + number of a shared point
  Array<TilePoint> indices;
  Array<TileRow> rows;
  Array<std::int32_t> outputs;
  Array<std::int32_t> written;       ///< TileOrder::tiles: written[i] is the level's number of the point written i-th
  Array<double> weights;             ///< of all level tables
  Array<float> weightsSingle;        ///< the same, rounded
  std::vector<SharedPoints> shared;  ///< of levels rootLevel + 1 .. lastLevel, of one more with exact normals; empty
                                     ///< where nothing is too large
  std::int32_t largestTile = 0;      ///< the most points of a tile
  TileNormalKind normalKind = TileNormalKind::none;
  TileNormals normals;  ///< TileNormalKind::fast
  TileLimits limits;    ///< TileNormalKind::exact

  template <class Real>
  std::span<const Real> weightsAs() const;
  /// Bytes held by the arrays.
  std::int64_t byteCount() const;
  /// The tiles that write the points `points` of level `level`, ascending: evaluating only these gives those points.
  /// Linear in the table. Points that no tile writes (those of shared faces) are written with any choice of tiles; at
  /// levels up to rootLevel these are all. TileOrder::tiles: of the last level, by the level's numbers.
  std::vector<std::int32_t> tilesOf(std::int32_t level, std::span<const std::int32_t> points) const;
};

template <>
inline std::span<const double> TileTable::weightsAs<double>() const {
  return weights;
}
template <>
inline std::span<const float> TileTable::weightsAs<float>() const {
  return weightsSingle;
}

/// Cuts a refinement into tiles, in parallel and always alike. Errors: invalidOption for a level that the refinement
/// doesn't have, scratchPoints out of range, exact normals of a level that has no limits; tooLarge where a single face
/// or row reads more than a tile can hold. Linear in the refinement's tables.
Result<TileTable> buildTileTable(const Refinement& refinement, const TileOptions& options = {});

}  // namespace honeycomb::Far
