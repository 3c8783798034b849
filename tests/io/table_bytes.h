#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <vector>

#include "far/base/index.h"
#include "io/checksum.h"
#include "io/table_file.h"
#include "io/table_format.h"
#include "osd/cpu_evaluator.h"
#include "osd/tile_evaluator.h"
#include "tests/support/must.h"
#include "tests/support/random_tables.h"

/// The bytes of table files, put right where they are wrong, and all that can be done with them.
namespace honeycomb::Io::Test {

using Bytes = std::vector<std::byte>;

/// In memory of exactly its size, so that the address sanitizer sees a read past its end.
inline Result<TableFile> readTable(const Bytes& bytes, TableFile::Trust trust = TableFile::Trust::nobody) {
  const auto kept = std::make_shared<const Bytes>(bytes);
  return TableFile::read(*kept, kept, "a.hct", trust);
}

inline TableHeader headerOf(const Bytes& bytes) {
  TableHeader header;
  std::memcpy(&header, bytes.data(), sizeof(header));
  return header;
}
inline TableEntry entryOf(const Bytes& bytes, std::size_t i) {
  TableEntry entry;
  std::memcpy(&entry, bytes.data() + sizeof(TableHeader) + i * sizeof(entry), sizeof(entry));
  return entry;
}
inline void setEntry(Bytes& bytes, std::size_t i, const TableEntry& entry) {
  std::memcpy(bytes.data() + sizeof(TableHeader) + i * sizeof(entry), &entry, sizeof(entry));
}

/// Makes the checksums of directory and header right again, as somebody would who means harm.
inline void repair(Bytes& bytes) {
  TableHeader header = headerOf(bytes);
  const std::size_t directory = header.sectionCount * sizeof(TableEntry);
  if (bytes.size() - sizeof(header) >= directory)
    header.directoryChecksum = checksum(std::span(bytes).subspan(sizeof(header), directory));
  header.headerChecksum = checksum(std::as_bytes(std::span(&header, 1)).first(offsetof(TableHeader, headerChecksum)));
  std::memcpy(bytes.data(), &header, sizeof(header));
}

/// The points of the last level, by any evaluator of levels.
template <class Evaluator>
std::vector<float> pointsBy(Evaluator evaluator, Far::LevelTables levels, std::uint32_t seed = 7) {
  const std::vector<float> control = honeycomb::Test::randomNumbers(3 * std::int64_t{levels.pointCount(0)}, seed);
  std::vector<float> points(3 * at(levels.pointCount(levels.levelCount())));
  honeycomb::Test::must(evaluator.template evaluate<float>(levels, levels.levelCount(), {control, {}}, {points, {}}));
  return points;
}

/// Points and normals (zeros without) of the last level, by tiles.
struct TiledPoints {
  std::vector<float> points, normals;
  bool operator==(const TiledPoints&) const = default;
};
inline TiledPoints pointsByTiles(Far::LevelTables levels, const Far::TileTable& tiles,
                                 Osd::CpuEvaluator::Instructions instructions) {
  const std::vector<float> control = honeycomb::Test::randomNumbers(3 * std::int64_t{levels.pointCount(0)});
  TiledPoints result{std::vector<float>(3 * at(tiles.pointCount.back())),
                     std::vector<float>(3 * at(tiles.pointCount.back()))};
  Osd::TileRequest<float> request;
  if (tiles.normalKind != Far::TileNormalKind::none) request.normals = {result.normals, {}};
  Osd::TileEvaluator evaluator({.instructions = instructions});
  honeycomb::Test::must(
      evaluator.evaluate<float>(levels, tiles, tiles.lastLevel, {control, {}}, {result.points, {}}, request));
  return result;
}

/// The exact normals of vertices, from points of the last level.
inline std::vector<float> limitNormals(Far::LevelTables levels, const std::vector<float>& points) {
  std::vector<float> normals(3 * at(levels.limits().vertices.elementCount));
  honeycomb::Test::must(Osd::SerialEvaluator().vertexLimits<float>(levels.limits(), {points, {}}, {}, {normals, {}}));
  return normals;
}

/// Does all that can be done with a file. What is wrong with it, if anything.
inline Result<void> useAll(const Bytes& bytes) {
  const auto file = readTable(bytes);
  if (!file) return tl::unexpected(file.error());
  const auto mesh = file->mesh();
  const auto levels = file->levels();
  const auto tiles = file->tiles();
  // How many control points it reads is the caller's to judge.
  if (levels && levels->pointCount(0) < 1000) {
    const std::vector<float> points = pointsBy(Osd::SerialEvaluator(), *levels);
    static_cast<void>(pointsBy(Osd::SimdEvaluator(), *levels));
    if (file->hasLimits()) static_cast<void>(limitNormals(*levels, points));
    if (tiles && *tiles != nullptr) {
      static_cast<void>(pointsByTiles(*levels, **tiles, Osd::CpuEvaluator::Instructions::plain));
      static_cast<void>(pointsByTiles(*levels, **tiles, Osd::CpuEvaluator::Instructions::vectors));
    }
  }
  if (!levels) return tl::unexpected(levels.error());
  if (!tiles) return tl::unexpected(tiles.error());
  if (!mesh) return tl::unexpected(mesh.error());
  return {};
}

}  // namespace honeycomb::Io::Test
