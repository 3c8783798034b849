#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "far/tables/limit_table.h"
#include "far/tables/tile_table.h"

/// The bytes of a table file (.hct), all numbers little-endian; docs/table_file.md draws them.
///     | header 64 | directory: 64 a section | sections, each from a multiple of 64 bytes on, zeros between |
namespace honeycomb::Io {

static_assert(std::endian::native == std::endian::little, "table files are mapped and used in place: little-endian");

constexpr std::size_t kTableAlignment = 64;
/// What this program writes. It reads files of this version and the one before, and newer ones that say it can.
constexpr std::uint32_t kTableVersion = 1;

/// As in PNG: a byte that is no text, the name, and line ends that transfer as text would change.
constexpr std::array<std::uint8_t, 8> kTableMagic{0x89, 'H', 'C', 'T', '\r', '\n', 0x1a, '\n'};

struct TableHeader {
  std::array<std::uint8_t, 8> magic = kTableMagic;
  std::uint32_t version = kTableVersion;        ///< of the program that wrote it
  std::uint32_t neededVersion = kTableVersion;  ///< the oldest reader that understands it
  std::uint64_t fileBytes = 0;
  std::uint64_t meshHash = 0;  ///< of the control mesh: see meshHash()
  std::uint32_t sectionCount = 0;
  std::uint32_t reserved = 0;
  std::uint64_t reservedToo = 0;
  std::uint64_t directoryChecksum = 0;
  std::uint64_t headerChecksum = 0;  ///< of the 56 bytes before
};
static_assert(sizeof(TableHeader) == 64 && offsetof(TableHeader, headerChecksum) == 56);

struct TableEntry {
  std::uint32_t kind = 0;                       ///< TableArray
  std::uint32_t table = 0;                      ///< which of the tables that have such an array
  std::uint32_t elementBytes = 0;               ///< of an element
  std::uint32_t flags = 0;                      ///< bit 0: a reader that doesn't know the kind may do without it
  std::uint64_t offset = 0;                     ///< from the file's beginning
  std::uint64_t count = 0;                      ///< elements
  std::uint64_t checksum = 0;                   ///< XXH3 of its bytes
  std::uint32_t neededVersion = kTableVersion;  ///< the oldest reader that knows the kind
  std::array<std::uint32_t, 5> reserved{};
};
static_assert(sizeof(TableEntry) == 64 && offsetof(TableEntry, reserved) == 44);
constexpr std::uint32_t kOptionalSection = 1;

/// What a section holds. Numbers are never used again for something else.
enum class TableArray : std::uint32_t {
  info = 1,
  steps = 2,
  primvars = 3,
  faceOffsets = 8,
  faceVertices = 9,
  faceOrigins = 10,
  triangles = 11,
  lines = 12,
  levelCounts = 16,
  circulants = 17,
  projected = 18,
  dense = 19,
  looseOutputs = 20,
  looseOffsets = 21,
  summedOutputs = 22,
  summedOffsets = 23,
  shareOffsets = 24,
  shareFaces = 25,
  indices = 26,
  weights = 27,
  weightsSingle = 28,
  limitCounts = 32,
  limitBatches = 33,
  limitElements = 34,
  limitIndices = 35,
  limitWeights = 36,
  limitWeightsSingle = 37,
  tileCounts = 48,
  tilePointCount = 49,
  tiles = 50,
  tileSteps = 51,
  tileStages = 52,
  tileImports = 53,
  tileIndices = 54,
  tileRows = 55,
  tileOutputs = 56,
  tileWritten = 57,
  tileWeights = 58,
  tileWeightsSingle = 59,
  sharedFirst = 60,
  sharedWritten = 61,
  normalTiles = 64,
  normalImports = 65,
  normalFrames = 66,
  normalIndices = 67,
  normalFirstFace = 68,
  normalFaces = 69,
  normalWeights = 70,
  normalWeightsSingle = 71,
  normalSharedOffsets = 72,
  normalSharedFaces = 73,
  normalBorn = 74,
  exactTiles = 80,
  exactFrames = 81,
  exactIndices = 82,
  exactWeights = 83,
  exactWeightsSingle = 84,
  exactRingTiles = 85,
  exactRings = 86,
  exactWindows = 87
};

/// "tileImports"; empty for a kind that this reader doesn't know.
std::string_view arrayName(std::uint32_t kind);

/// TableEntry::table of a level table: k leads to level k.
constexpr std::uint32_t kLimitChild = 64;   ///< LimitTable::child
constexpr std::uint32_t kSharedSets = 128;  ///< and on: TileTable::shared
/// TableEntry::table of limit rows.
constexpr std::uint32_t kFaceLimits = 0, kVertexLimits = 1, kVertexLimitsHere = 2;
constexpr std::uint32_t kSharedNormals = 64;  ///< and on: TileNormals::shared
constexpr std::uint32_t kSharedLimits = 128;  ///< TileLimits::shared

/// Of TableArray::info.
struct InfoRecord {
  std::int32_t levelCount = 0;
  std::int32_t vertexCount = 0;    ///< of the last level
  std::int32_t faceCount = 0;      ///< of the last level
  std::int32_t inputVertices = 0;  ///< of the control mesh
  std::int32_t inputFaces = 0;
  std::array<std::int32_t, 3> reserved{};
};

/// Of TableArray::levelCounts: what a LevelTable has beside its arrays.
struct LevelRecord {
  std::int32_t source = 0, target = 0;
  std::int32_t looseIndex = 0, looseWeight = 0;
  std::int32_t summedIndex = 0, summedWeight = 0;
  std::int32_t firstShare = 0;
  std::int32_t reserved = 0;
};

/// Of TableArray::limitCounts.
struct LimitRecord {
  std::int32_t source = 0, elements = 0;
};

/// TileRecord::places of files whose faces in fours have no point in front.
constexpr std::int32_t kFormerFours = 1;

/// Of TableArray::tileCounts: what a TileTable has beside its arrays.
struct TileRecord {
  std::int32_t rootLevel = 0, lastLevel = 0, rootPoints = 0, largestTile = 0;
  std::int32_t order = 0, places = 0, normalKind = 0;  ///< TileOrder, TilePlaces, TileNormalKind
  std::int32_t sharedSets = 0;
  std::int32_t neighbours = 0, sharedNormals = 0, largestNormals = 0, normalLevels = 0;
};

/// The bytes of an element that mean nothing and are zero in a file: [begin, end).
template <class T>
struct Padding {
  static constexpr std::size_t begin = 0, end = 0;
};
template <>
struct Padding<Far::CirculantBatch> {
  static constexpr std::size_t begin = 25, end = 28;
};
template <>
struct Padding<Far::TileStep> {
  static constexpr std::size_t begin = 6, end = 8;
};
static_assert(sizeof(Far::CirculantBatch) == 28 && offsetof(Far::CirculantBatch, form) == 24);
static_assert(sizeof(Far::TileStep) == 28 && offsetof(Far::TileStep, sameWeights) == 4 &&
              offsetof(Far::TileStep, pairs) == 5 && offsetof(Far::TileStep, width) == 8);
static_assert(sizeof(Far::ProjectedFace) == 24 && sizeof(Far::DenseRows) == 20 && sizeof(Far::FrameBatch) == 20);
static_assert(sizeof(Far::Tile) == 20 && sizeof(Far::TileStage) == 12 && sizeof(Far::TileRow) == 8);
static_assert(sizeof(Far::TileNormalRange) == 20 && sizeof(Far::TileFrames) == 16 && sizeof(Far::TileBorn) == 8);
static_assert(sizeof(Far::TileVertexFrames) == 24 && sizeof(Far::TileLimits::Range) == 8 &&
              sizeof(Far::TileRings) == 12 && sizeof(Far::SharedPoints::Run) == 12 && sizeof(Far::TilePoint) == 2);

}  // namespace honeycomb::Io
