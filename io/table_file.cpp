#include "io/table_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstring>
#include <mutex>
#include <optional>
#include <string_view>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/tables/table_proof.h"
#include "far/tables/tile_proof.h"
#include "io/checksum.h"
#include "io/mapped_file.h"
#include "io/table_arrays.h"
#include "io/table_directory.h"

namespace honeycomb::Io {

/// A proof that is made once, by whoever needs it first.
class ProvenOnce {
 public:
  template <class Prove>
  const Result<void>& get(const Prove& prove) const {
    // Isolated: a thread that waits for the proof's loops must not take up other work, which might ask for it too.
    std::call_once(flag_, [&] { Parallel::isolated([&] { result_ = prove(); }); });
    return result_;
  }

 private:
  mutable std::once_flag flag_;
  mutable Result<void> result_;
};

namespace {

/// Hands the sections of a file to the arrays of tables.
class SectionReader {
 public:
  SectionReader(const TableDirectory& directory, std::span<const std::byte> bytes,
                const std::shared_ptr<const void>& keeper)
      : directory_(directory), bytes_(bytes), keeper_(keeper) {}

  template <class T>
  void operator()(TableArray kind, std::uint32_t table, Array<T>& values) {
    if (const auto found = section<T>(kind, table)) values = Array<T>::inPlaceOf(*found, keeper_);
  }
  template <class T>
  void operator()(TableArray kind, std::uint32_t table, SharedArray<T>& values) {
    if (const auto found = section<T>(kind, table))
      values = SharedArray<T>(std::make_shared<const Array<T>>(Array<T>::inPlaceOf(*found, keeper_)));
  }
  /// Batches are few.
  template <class T>
  void operator()(TableArray kind, std::uint32_t table, std::vector<T>& values) {
    if (const auto found = section<T>(kind, table)) values.assign(found->begin(), found->end());
  }
  template <class T>
  void operator()(TableArray kind, std::uint32_t table, std::span<const T>& values) {
    if (const auto found = section<T>(kind, table)) values = *found;
  }
  /// A record: exactly one.
  template <class T>
  void operator()(TableArray kind, std::uint32_t table, T& record) {
    const auto found = section<T>(kind, table);
    if (!found) return;
    if (found->size() != 1) return wrong(*directory_.find(kind, table));
    std::memcpy(&record, found->data(), sizeof(T));
  }

  bool has(TableArray kind, std::uint32_t table) const { return directory_.find(kind, table) != nullptr; }
  /// Of a section whose elements aren't what this reader takes them for.
  const std::optional<std::string>& error() const { return error_; }

 private:
  template <class T>
  std::optional<std::span<const T>> section(TableArray kind, std::uint32_t table) {
    const TableEntry* entry = directory_.find(kind, table);
    if (entry == nullptr) return std::nullopt;
    if (entry->elementBytes != sizeof(T)) {
      wrong(*entry);
      return std::nullopt;
    }
    const auto* first = reinterpret_cast<const T*>(bytes_.data() + entry->offset);
    return std::span<const T>(first, entry->count);
  }
  void wrong(const TableEntry& entry) {
    if (!error_) error_ = fmt::format("section {} at byte {} has other elements", sectionName(entry), entry.offset);
  }

  const TableDirectory& directory_;
  std::span<const std::byte> bytes_;
  std::shared_ptr<const void> keeper_;
  std::optional<std::string> error_;
};

std::vector<std::string> linesOf(std::span<const char> text) {
  std::vector<std::string> all;
  for (auto first = text.begin(); first != text.end();) {
    const auto end = std::find(first, text.end(), '\n');
    all.emplace_back(first, end);
    first = end == text.end() ? end : end + 1;
  }
  return all;
}

/// "positions 3"; nothing where the line is something else.
std::optional<TablePrimvar> primvarOf(std::string_view line) {
  const std::size_t blank = line.rfind(' ');
  TablePrimvar primvar;
  if (blank == std::string_view::npos || blank == 0) return std::nullopt;
  const auto [end, error] = std::from_chars(line.data() + blank + 1, line.data() + line.size(), primvar.length);
  if (error != std::errc{} || end != line.data() + line.size() || primvar.length < 1) return std::nullopt;
  primvar.name = line.substr(0, blank);
  return primvar;
}

}  // namespace

struct TableFile::State {
  std::string name;
  std::shared_ptr<const void> keeper;
  std::span<const std::byte> bytes;
  Trust trust = Trust::nobody;
  TableInfo info;
  InfoRecord record;
  std::vector<TableSection> sections;
  std::vector<Far::LevelTable> levels;
  Far::LimitTable limits;
  std::optional<Far::TileTable> tiles;
  TableMesh mesh;
  ProvenOnce levelsProof, tilesProof, meshProof;

  tl::unexpected<Error> unsound(const std::string& what) const {
    return fail(ErrorCode::invalidFile, fmt::format("{}: {}; make it again with `honeycomb table build`", name, what));
  }
  Result<void> about(std::string_view what, const Result<void>& proof) const {
    if (proof) return {};
    return unsound(fmt::format("{}: {}", what, proof.error().message));
  }
  Far::LevelTables views() const { return {levels, limits}; }

  Result<void> readInfo(SectionReader& reader);
  Result<void> readTables(SectionReader& reader);
  Result<void> proveShapes() const;
  Result<void> proveLevels() const;
  Result<void> proveTileTable() const;
  Result<void> proveMesh() const;
  Result<void> compareChecksums() const;
};

Result<void> TableFile::State::readInfo(SectionReader& reader) {
  reader(TableArray::info, 0, record);
  std::span<const char> steps, primvars;
  reader(TableArray::steps, 0, steps);
  reader(TableArray::primvars, 0, primvars);
  if (record.levelCount < 1 || record.levelCount > Far::kMaxLevels || record.vertexCount < 0 || record.faceCount < 0 ||
      record.inputVertices < 0 || record.inputFaces < 0)
    return unsound("its counts are none of a mesh");
  info.inputVertices = record.inputVertices;
  info.inputFaces = record.inputFaces;
  info.steps = linesOf(steps);
  if (std::ssize(info.steps) != record.levelCount) return unsound("it describes other levels than it has");
  for (const std::string& line : linesOf(primvars)) {
    const auto primvar = primvarOf(line);
    if (!primvar) return unsound("a primvar has no name and length");
    info.primvars.push_back(*primvar);
  }
  return {};
}

Result<void> TableFile::State::readTables(SectionReader& reader) {
  // visit() takes its visitor by const reference.
  const auto visit = [&reader](TableArray kind, std::uint32_t table, auto& values) { reader(kind, table, values); };
  levels.resize(at(record.levelCount) + 1);
  for (std::size_t k = 1; k < levels.size(); ++k) visitArrays(levels[k], static_cast<std::uint32_t>(k), visit);
  if (reader.has(TableArray::limitCounts, kFaceLimits)) visitArrays(limits, visit);
  if (reader.has(TableArray::tileCounts, 0)) {
    TileRecord counts;
    reader(TableArray::tileCounts, 0, counts);
    tiles.emplace();
    if (counts.places == kFormerFours) return unsound("its tiles keep their points as earlier programs did");
    if (!setRecord(counts, *tiles)) return unsound("its tiles have counts of no tiles");
    visitArrays(*tiles, visit);
    // Files of before these were known.
    if (tiles->normals.born.empty()) tiles->normals.born.resize(tiles->normals.firstFace.size(), Far::TileBorn{});
    if (tiles->limits.ringTiles.empty()) tiles->limits.ringTiles.resize(tiles->limits.tiles.size(), {0, 0});
  }
  mesh.vertexCount = record.vertexCount;
  reader(TableArray::faceOffsets, 0, mesh.faceOffsets);
  reader(TableArray::faceVertices, 0, mesh.faceVertices);
  reader(TableArray::faceOrigins, 0, mesh.faceOrigins);
  reader(TableArray::triangles, 0, mesh.triangles);
  reader(TableArray::lines, 0, mesh.lines);
  if (reader.error()) return unsound(*reader.error());
  return {};
}

/// All that follows from records and batches.
Result<void> TableFile::State::proveShapes() const {
  for (std::size_t k = 1; k < levels.size(); ++k) {
    if (auto sound = about(fmt::format("level {}", k), Far::proveShape(levels[k])); !sound) return sound;
    if (k > 1 && levels[k].sourceCount != levels[k - 1].targetCount)
      return unsound(fmt::format("level {} reads other points than level {} has", k, k - 1));
  }
  if (record.vertexCount > levels.back().targetCount) return unsound("it has more vertices than points");
  if (std::ssize(mesh.faceOffsets) != std::int64_t{record.faceCount} + 1 ||
      std::ssize(mesh.faceOrigins) != record.faceCount || mesh.triangles.size() % 3 != 0 || mesh.lines.size() % 2 != 0)
    return unsound("its faces contradict their number");
  const bool limited = limits.faces.sourceCount > 0;
  if (limited && (limits.vertices.elementCount != record.vertexCount || limits.faces.elementCount != record.faceCount))
    return unsound("its limits are of another mesh");
  return about("limits", Far::proveShape(limits, levels.back().targetCount));
}

Result<void> TableFile::State::proveLevels() const {
  for (std::size_t k = 1; k < levels.size(); ++k) {
    if (auto sound = about(fmt::format("level {}", k), Far::proveIndices(levels[k])); !sound) return sound;
  }
  return about("limits", Far::proveIndices(limits));
}

Result<void> TableFile::State::proveTileTable() const {
  if (!tiles) return {};
  // A truth value of another byte than 0 and 1 must not even be read.
  const auto steps = std::as_bytes(std::span(tiles->steps));
  for (const std::size_t flag : {offsetof(Far::TileStep, sameWeights), offsetof(Far::TileStep, pairs)}) {
    for (std::size_t i = flag; i < steps.size(); i += sizeof(Far::TileStep)) {
      if (steps[i] > std::byte{1})
        return unsound(fmt::format("tiles: step {} has no such weights or pairs", i / sizeof(Far::TileStep)));
    }
  }
  return about("tiles", Far::proveTiles(*tiles, views()));
}

Result<void> TableFile::State::proveMesh() const {
  if (const auto i = Far::firstNotAscending(mesh.faceOffsets, 3, std::ssize(mesh.faceVertices)); i >= 0)
    return unsound(fmt::format("faceOffsets: element {} is out of place", i));
  if (mesh.faceOffsets.front() != 0 || mesh.faceOffsets.back() != std::ssize(mesh.faceVertices))
    return unsound("faceOffsets: they don't cover all corners");
  struct Vertices {
    const char* section;
    std::span<const std::int32_t> numbers;
  };
  for (const Vertices& vertices : {Vertices{"faceVertices", mesh.faceVertices}, Vertices{"triangles", mesh.triangles},
                                   Vertices{"lines", mesh.lines}}) {
    if (const auto i = Far::firstOutside(vertices.numbers, mesh.vertexCount); i >= 0)
      return unsound(fmt::format("{}: element {} is no vertex", vertices.section, i));
  }
  const auto noOrigin = [&](std::int32_t origin) {
    return origin >= record.inputFaces || (origin < 0 && -1 - origin >= record.inputVertices);
  };
  const auto found = std::ranges::find_if(mesh.faceOrigins, noOrigin);
  if (found != mesh.faceOrigins.end())
    return unsound(fmt::format("faceOrigins: element {} is no face", found - mesh.faceOrigins.begin()));
  return {};
}

Result<void> TableFile::State::compareChecksums() const {
  std::vector<std::uint8_t> differs(sections.size());
  Parallel::forEach(
      0, std::ssize(sections),
      [&](std::int64_t i) { differs[at(i)] = checksum(sections[at(i)].bytes) != sections[at(i)].checksum ? 1 : 0; }, 1);
  const auto first = std::ranges::find(differs, 1);
  if (first == differs.end()) return {};
  const TableSection& section = sections[at(first - differs.begin())];
  return unsound(fmt::format("section {} at byte {} is damaged: its checksum differs", section.name, section.offset));
}

Result<TableFile> TableFile::open(const std::filesystem::path& path, Trust trust) {
  Result<MappedFile> mapped = MappedFile::open(path);
  if (!mapped) return tl::unexpected(mapped.error());
  const auto file = std::make_shared<const MappedFile>(std::move(*mapped));
  return read(file->bytes(), file, path.string(), trust);
}

Result<TableFile> TableFile::read(std::span<const std::byte> bytes, std::shared_ptr<const void> keeper,
                                  const std::string& name, Trust trust) {
  const Result<TableDirectory> directory = readDirectory(bytes, name);
  if (!directory) return tl::unexpected(directory.error());
  const auto state = std::make_shared<State>();
  state->name = name;
  state->bytes = bytes;
  state->trust = trust;
  state->info.meshHash = directory->header.meshHash;
  for (const TableEntry& entry : directory->entries) {
    state->sections.push_back({sectionName(entry), entry.offset,
                               bytes.subspan(entry.offset, entry.count * entry.elementBytes),
                               static_cast<std::int64_t>(entry.count), entry.checksum});
  }
  SectionReader reader(*directory, bytes, keeper);
  state->keeper = std::move(keeper);
  if (auto done = state->readInfo(reader); !done) return tl::unexpected(done.error());
  if (auto done = state->readTables(reader); !done) return tl::unexpected(done.error());
  if (auto sound = state->proveShapes(); !sound) return tl::unexpected(sound.error());
  return TableFile(state);
}

const TableInfo& TableFile::info() const {
  return state_->info;
}
std::int32_t TableFile::levelCount() const {
  return state_->record.levelCount;
}
std::int32_t TableFile::controlPoints() const {
  return state_->levels[1].sourceCount;
}
std::int32_t TableFile::vertexCount() const {
  return state_->record.vertexCount;
}
std::int32_t TableFile::faceCount() const {
  return state_->record.faceCount;
}
bool TableFile::hasLimits() const {
  return state_->limits.faces.sourceCount > 0;
}
bool TableFile::hasTiles() const {
  return state_->tiles.has_value();
}
std::int64_t TableFile::byteCount() const {
  return std::ssize(state_->bytes);
}
std::span<const TableSection> TableFile::sections() const {
  return state_->sections;
}

Result<Far::LevelTables> TableFile::levels() const {
  if (state_->trust == Trust::nobody) {
    const auto& sound = state_->levelsProof.get([this] { return state_->proveLevels(); });
    if (!sound) return tl::unexpected(sound.error());
  }
  return state_->views();
}

Result<const Far::TileTable*> TableFile::tiles() const {
  if (state_->trust == Trust::nobody) {
    const auto& sound = state_->tilesProof.get([this] { return state_->proveTileTable(); });
    if (!sound) return tl::unexpected(sound.error());
  }
  return state_->tiles ? &*state_->tiles : nullptr;
}

Result<TableMesh> TableFile::mesh() const {
  if (state_->trust == Trust::nobody) {
    const auto& sound = state_->meshProof.get([this] { return state_->proveMesh(); });
    if (!sound) return tl::unexpected(sound.error());
  }
  return state_->mesh;
}

Result<void> TableFile::check() const {
  if (auto same = state_->compareChecksums(); !same) return same;
  if (auto sound = state_->levelsProof.get([this] { return state_->proveLevels(); }); !sound) return sound;
  if (auto sound = state_->tilesProof.get([this] { return state_->proveTileTable(); }); !sound) return sound;
  return state_->meshProof.get([this] { return state_->proveMesh(); });
}

bool setRecord(const TileRecord& record, Far::TileTable& tiles) {
  const auto isOneOf = [](std::int32_t value, auto last) {
    return value >= 0 && value <= static_cast<std::int32_t>(last);
  };
  const auto places = static_cast<Far::TilePlaces>(record.places);
  if (!isOneOf(record.order, Far::TileOrder::tiles) || !isOneOf(record.places, Far::TilePlaces::fours) ||
      (places != Far::TilePlaces::faces && places != Far::TilePlaces::fours) ||
      !isOneOf(record.normalKind, Far::TileNormalKind::exact) || !isOneOf(record.sharedSets, Far::kMaxLevels + 1) ||
      !isOneOf(record.normalLevels, Far::kMaxLevels))
    return false;
  tiles.rootLevel = record.rootLevel;
  tiles.lastLevel = record.lastLevel;
  tiles.rootPoints = record.rootPoints;
  tiles.largestTile = record.largestTile;
  tiles.order = static_cast<Far::TileOrder>(record.order);
  tiles.places = places;
  tiles.normalKind = static_cast<Far::TileNormalKind>(record.normalKind);
  tiles.shared.resize(at(record.sharedSets));
  tiles.normals.neighbours = record.neighbours;
  tiles.normals.sharedCount = record.sharedNormals;
  tiles.normals.largestTile = record.largestNormals;
  tiles.normals.shared.resize(at(record.normalLevels));
  return true;
}

}  // namespace honeycomb::Io
