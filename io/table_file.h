#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "far/base/result.h"
#include "far/tables/level_tables.h"
#include "far/tables/tile_table.h"
#include "far/topology/polygons.h"

namespace honeycomb::Io {

/// Values that every control point has, and how many: positions 3, colours 3, texture coordinates 2.
struct TablePrimvar {
  std::string name;  ///< without blanks
  std::int32_t length = 0;
  bool operator==(const TablePrimvar&) const = default;
};

/// What a table file says beside its tables.
struct TableInfo {
  std::uint64_t meshHash = 0;          ///< meshHash() of the control mesh
  std::int32_t inputVertices = 0;      ///< of the control mesh
  std::int32_t inputFaces = 0;         ///< of the control mesh
  std::vector<std::string> steps;      ///< per level 1 .. levelCount: scheme and options, as text
  std::vector<TablePrimvar> primvars;  ///< what the control points had when the file was made
};

/// Tells control meshes apart: of the polygons, creases and tagged corners, not of positions. Linear.
std::uint64_t meshHash(const Far::Polygons& polygons);

/// What goes into a table file.
struct TableContent {
  const Far::Refinement& refinement;      ///< at least one level; its limits, if it has any, go along
  const Far::TileTable* tiles = nullptr;  ///< of the refinement; null: none
  const TableInfo& info;                  ///< as many steps as levels
  bool triangles = true;                  ///< index buffer of triangles: 12 bytes each
  bool lines = true;                      ///< index buffer of edges: 8 bytes each
};

/// Writes a table file (.hct), beside its name and then renamed. The same content gives the same bytes.
/// Errors: invalidOption for a refinement without levels or steps that aren't one a level; unwritable.
Result<void> writeTableFile(const std::filesystem::path& path, const TableContent& content);

/// The mesh of the last level, for drawing and for files.
struct TableMesh {
  std::int32_t vertexCount = 0;                ///< the first points of the last level are its vertices
  std::span<const std::int32_t> faceOffsets;   ///< faces + 1, into
  std::span<const std::int32_t> faceVertices;  ///< loops, counter-clockwise
  std::span<const std::int32_t> faceOrigins;   ///< per face: the control face f it descends from, or -1 - v: vertex v
  std::span<const std::int32_t> triangles;     ///< 3 vertices each, as Far::Refinement::triangles; perhaps none
  std::span<const std::int32_t> lines;         ///< 2 vertices each, as Far::Refinement::lines; perhaps none
};

/// One array of a table file.
struct TableSection {
  std::string name;                  ///< "level 3 indices"
  std::uint64_t offset = 0;          ///< in the file, bytes
  std::span<const std::byte> bytes;  ///< of the mapping
  std::int64_t count = 0;            ///< elements
  std::uint64_t checksum = 0;        ///< XXH3 that its bytes should have
};

/// A table file, mapped and used in place: no array is copied. Copies share the mapping; tables live as long as one of
/// them, or as copies of its arrays' owner do. All functions may be called from several threads at once.
///
/// open() reads the header, the directory and the batches, and proves that they fit each other: time that doesn't
/// depend on the size of the arrays. levels(), tiles() and mesh() prove the indices of what they hand out when they
/// are called for the first time, in parallel, as fast as memory is read, so that no evaluator ever meets an index that
/// leads out of its arrays, whatever stands in the file. Checksums are compared by check() alone.
class TableFile {
 public:
  /// Whom to believe.
  enum class Trust {
    nobody,  ///< every index is proven before it is used
    file     ///< indices aren't proven: for files that check() has found sound and nobody else can write to, as an
             ///< engine knows of those that it installed. A broken file is then undefined behaviour.
  };

  /// Maps a file. Errors: unreadable; invalidFile, naming the file, what is wrong and what to do.
  static Result<TableFile> open(const std::filesystem::path& path, Trust trust = Trust::nobody);
  /// The same of bytes in memory, from a multiple of 8 on, which `keeper` keeps and nobody changes. `name` stands for
  /// them in messages.
  static Result<TableFile> read(std::span<const std::byte> bytes, std::shared_ptr<const void> keeper,
                                const std::string& name, Trust trust = Trust::nobody);

  const TableInfo& info() const;
  /// Levels are 1 .. levelCount().
  std::int32_t levelCount() const;
  std::int32_t controlPoints() const;  ///< points that level 1 reads
  std::int32_t vertexCount() const;    ///< of the last level
  std::int32_t faceCount() const;      ///< of the last level
  bool hasLimits() const;
  bool hasTiles() const;
  std::int64_t byteCount() const;
  /// In the order of the file.
  std::span<const TableSection> sections() const;

  /// For every evaluator; a view that lives no longer than the file. Errors: invalidFile, naming section and element.
  Result<Far::LevelTables> levels() const;
  /// Null where the file has none. Errors: as levels().
  Result<const Far::TileTable*> tiles() const;
  /// Errors: as levels().
  Result<TableMesh> mesh() const;

  /// Compares every checksum and proves everything, in parallel. Errors: invalidFile, naming the first section that is
  /// wrong and where it stands.
  Result<void> check() const;

 private:
  struct State;
  explicit TableFile(std::shared_ptr<const State> state) : state_(std::move(state)) {}
  std::shared_ptr<const State> state_;
};

/// A section of two files that isn't the same.
struct TableDifference {
  std::string section;        ///< TableSection::name
  std::int64_t element = -1;  ///< the first that differs, or the shorter one's size; -1: one file hasn't the section
  bool inFirst = true;        ///< has the first file the section?
  bool inSecond = true;       ///< has the second?
};

/// The sections that differ, in the order of the files. Linear.
std::vector<TableDifference> differences(const TableFile& first, const TableFile& second);

}  // namespace honeycomb::Io
