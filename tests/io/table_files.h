#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "far/base/index.h"
#include "io/checksum.h"
#include "io/table_file.h"
#include "io/table_format.h"
#include "osd/cpu_evaluator.h"
#include "osd/tile_evaluator.h"
#include "tests/io/files.h"
#include "tests/support/must.h"
#include "tests/support/random_tables.h"
#include "tests/support/refined.h"

/// Table files in memory, and what is evaluated by them.
namespace honeycomb::Io::Test {

using Bytes = std::vector<std::byte>;

/// A step a level, and positions.
inline TableInfo infoOf(const Far::Refinement& refinement) {
  TableInfo info;
  info.meshHash = 0x0123456789abcdef;
  info.inputVertices = refinement.level(0).topology.vertexCount();
  info.inputFaces = refinement.level(0).topology.faceCount();
  info.steps.assign(at(refinement.levelCount()), "akleman --tension paper");
  info.primvars = {{"positions", 3}, {"texture coordinates", 2}};
  return info;
}

/// The bytes of the file that is written.
inline Bytes tableBytes(const Far::Refinement& refinement, const Far::TileTable* tiles = nullptr) {
  const TemporaryFolder folder;
  honeycomb::Test::must(writeTableFile(folder / "a.hct", {refinement, tiles, infoOf(refinement)}));
  const std::string text = readBytes(folder / "a.hct");
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

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

}  // namespace honeycomb::Io::Test
