#include <fmt/format.h>

#include <cstring>
#include <utility>
#include <vector>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "io/checksum.h"
#include "io/output_file.h"
#include "io/table_arrays.h"
#include "io/table_file.h"

namespace honeycomb::Io {

namespace {

/// A section on its way into a file.
struct Piece {
  TableEntry entry;
  std::span<const std::byte> bytes;
};

/// Collects the sections of a file.
class TableImageWriter {
 public:
  template <class Values>
  void operator()(TableArray kind, std::uint32_t table, const Values& values) {
    if constexpr (std::is_class_v<Values> && requires { values.size(); }) {
      using T = typename Values::value_type;
      add<T>(kind, table, {values.data(), values.size()});
    } else {
      owned_.emplace_back(sizeof(Values));
      std::memcpy(owned_.back().data(), &values, sizeof(Values));
      add(kind, table, sizeof(Values), owned_.back());
    }
  }

  /// Values that nobody else keeps.
  template <class T>
  void keep(TableArray kind, std::vector<T> values) {
    const auto bytes = std::as_bytes(std::span(values));
    owned_.emplace_back(bytes.begin(), bytes.end());
    add(kind, 0, sizeof(T), owned_.back());
  }
  void keep(TableArray kind, const std::string& text) { keep(kind, std::vector<char>(text.begin(), text.end())); }

  Result<void> write(const std::filesystem::path& path, std::uint64_t meshHash);

 private:
  template <class T>
  void add(TableArray kind, std::uint32_t table, std::span<const T> values) {
    constexpr std::size_t kBegin = Padding<T>::begin, kEnd = Padding<T>::end;
    if constexpr (kBegin == kEnd) return add(kind, table, sizeof(T), std::as_bytes(values));
    const auto bytes = std::as_bytes(values);
    std::vector<std::byte>& copy = owned_.emplace_back(bytes.begin(), bytes.end());
    for (std::size_t i = 0; i < copy.size(); i += sizeof(T)) {
      std::fill(copy.begin() + static_cast<std::ptrdiff_t>(i + kBegin),
                copy.begin() + static_cast<std::ptrdiff_t>(i + kEnd), std::byte{});
    }
    add(kind, table, sizeof(T), copy);
  }

  /// What is empty has no section.
  void add(TableArray kind, std::uint32_t table, std::size_t elementBytes, std::span<const std::byte> bytes) {
    if (bytes.empty()) return;
    Piece piece;
    piece.entry.kind = static_cast<std::uint32_t>(kind);
    piece.entry.table = table;
    piece.entry.elementBytes = static_cast<std::uint32_t>(elementBytes);
    piece.entry.count = bytes.size() / elementBytes;
    piece.bytes = bytes;
    pieces_.push_back(piece);
  }

  std::vector<Piece> pieces_;
  std::vector<std::vector<std::byte>> owned_;
};

std::uint64_t aligned(std::uint64_t offset) {
  return (offset + kTableAlignment - 1) / kTableAlignment * kTableAlignment;
}

Result<void> TableImageWriter::write(const std::filesystem::path& path, std::uint64_t hash) {
  std::uint64_t end = sizeof(TableHeader) + pieces_.size() * sizeof(TableEntry);
  for (Piece& piece : pieces_) {
    piece.entry.offset = aligned(end);
    end = piece.entry.offset + piece.bytes.size();
  }
  Parallel::forEach(
      0, std::ssize(pieces_), [&](std::int64_t i) { pieces_[at(i)].entry.checksum = checksum(pieces_[at(i)].bytes); },
      1);
  std::vector<TableEntry> directory;
  for (const Piece& piece : pieces_) directory.push_back(piece.entry);
  TableHeader header;
  header.fileBytes = end;
  header.meshHash = hash;
  header.sectionCount = static_cast<std::uint32_t>(pieces_.size());
  header.directoryChecksum = checksum(std::as_bytes(std::span(directory)));
  const auto headerBytes = std::as_bytes(std::span(&header, 1));
  header.headerChecksum = checksum(headerBytes.first(offsetof(TableHeader, headerChecksum)));

  Result<OutputFile> file = OutputFile::create(path);
  if (!file) return tl::unexpected(file.error());
  if (auto done = file->write(headerBytes); !done) return done;
  if (auto done = file->write(std::as_bytes(std::span(directory))); !done) return done;
  std::uint64_t written = sizeof(TableHeader) + sizeof(TableEntry) * directory.size();
  constexpr std::array<std::byte, kTableAlignment> kZeros{};
  for (const Piece& piece : pieces_) {
    if (auto done = file->write(std::span(kZeros).first(piece.entry.offset - written)); !done) return done;
    if (auto done = file->write(piece.bytes); !done) return done;
    written = piece.entry.offset + piece.bytes.size();
  }
  return file->commit();
}

/// The caller's number of the control face of each face of the last level, or -1 - that of its control vertex.
std::vector<std::int32_t> inputOrigins(const Far::Refinement& refinement) {
  const Far::Topology& control = refinement.level(0).topology;
  const std::vector<Far::Origin> origins = refinement.faceOrigins(refinement.levelCount());
  std::vector<std::int32_t> numbers(origins.size());
  Parallel::forEach(0, std::ssize(origins), [&](std::int64_t f) {
    const Far::Origin& origin = origins[at(f)];
    numbers[at(f)] = origin.vertex ? -1 - origin.element : control.inputFace(origin.element);
  });
  return numbers;
}

std::string lines(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += text + "\n";
  return all;
}

void addMesh(const TableContent& content, TableImageWriter& image) {
  const Far::Refinement& refinement = content.refinement;
  const Far::Topology& last = refinement.last().topology;
  const std::int32_t level = refinement.levelCount();
  image(TableArray::faceOffsets, 0, last.faceOffsets());
  image(TableArray::faceVertices, 0, last.vert());
  image.keep(TableArray::faceOrigins, inputOrigins(refinement));
  if (content.triangles) image.keep(TableArray::triangles, refinement.triangles(level));
  if (content.lines) image.keep(TableArray::lines, refinement.lines(level));
}

void addInfo(const TableContent& content, TableImageWriter& image) {
  const Far::Topology& last = content.refinement.last().topology;
  InfoRecord record;
  record.levelCount = content.refinement.levelCount();
  record.vertexCount = last.vertexCount();
  record.faceCount = last.faceCount();
  record.inputVertices = content.info.inputVertices;
  record.inputFaces = content.info.inputFaces;
  image(TableArray::info, 0, record);
  image.keep(TableArray::steps, lines(content.info.steps));
  std::vector<std::string> primvars;
  for (const TablePrimvar& primvar : content.info.primvars) {
    primvars.push_back(fmt::format("{} {}", primvar.name, primvar.length));
  }
  image.keep(TableArray::primvars, lines(primvars));
}

}  // namespace

std::uint64_t meshHash(const Far::Polygons& polygons) {
  Checksum sum;
  sum.addValue(polygons.vertexCount);
  const auto add = [&](const auto& values) {
    sum.addValue(values.size());
    sum.add(std::as_bytes(std::span(values)));
  };
  add(polygons.faceOffsets);
  add(polygons.indices);
  add(polygons.corners);
  static_assert(sizeof(Far::Crease) == 16, "without padding");
  add(polygons.creases);
  return sum.value();
}

TileRecord recordOf(const Far::TileTable& tiles) {
  TileRecord record;
  record.rootLevel = tiles.rootLevel;
  record.lastLevel = tiles.lastLevel;
  record.rootPoints = tiles.rootPoints;
  record.largestTile = tiles.largestTile;
  record.order = static_cast<std::int32_t>(tiles.order);
  record.places = static_cast<std::int32_t>(tiles.places);
  record.normalKind = static_cast<std::int32_t>(tiles.normalKind);
  record.sharedSets = static_cast<std::int32_t>(tiles.shared.size());
  record.neighbours = tiles.normals.neighbours;
  record.sharedNormals = tiles.normals.sharedCount;
  record.largestNormals = tiles.normals.largestTile;
  record.normalLevels = static_cast<std::int32_t>(tiles.normals.shared.size());
  return record;
}

Result<void> writeTableFile(const std::filesystem::path& path, const TableContent& content) {
  const Far::Refinement& refinement = content.refinement;
  if (refinement.levelCount() < 1 || refinement.levelCount() > Far::kMaxLevels)
    return fail(ErrorCode::invalidOption,
                fmt::format("{}: a table file has 1 to {} levels; refine by so many", path.string(), Far::kMaxLevels));
  if (std::ssize(content.info.steps) != refinement.levelCount())
    return fail(ErrorCode::invalidOption,
                fmt::format("{}: {} steps are described and there are {}; describe each in TableInfo::steps",
                            path.string(), content.info.steps.size(), refinement.levelCount()));
  TableImageWriter image;
  const auto visit = [&image](TableArray kind, std::uint32_t table, const auto& values) { image(kind, table, values); };
  addInfo(content, image);
  for (std::int32_t k = 1; k <= refinement.levelCount(); ++k) {
    visitArrays(refinement.level(k).table, static_cast<std::uint32_t>(k), visit);
  }
  if (refinement.limits().faces.sourceCount > 0) visitArrays(refinement.limits(), visit);
  if (content.tiles != nullptr) {
    const TileRecord record = recordOf(*content.tiles);
    visit(TableArray::tileCounts, 0, record);
    visitArrays(*content.tiles, visit);
  }
  addMesh(content, image);
  return image.write(path, content.info.meshHash);
}

}  // namespace honeycomb::Io
