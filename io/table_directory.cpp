#include "io/table_directory.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "io/checksum.h"

namespace honeycomb::Io {

namespace {

template <class... Arguments>
tl::unexpected<Error> unsound(const std::string& name, fmt::format_string<Arguments...> text,
                              Arguments&&... arguments) {
  return fail(ErrorCode::invalidFile, name + ": " + fmt::format(text, std::forward<Arguments>(arguments)...));
}

constexpr const char* kBuildAgain = "make it again with `honeycomb table build`";

Result<void> checkVersion(const TableHeader& header, const std::string& name, std::uint32_t reader) {
  if (header.neededVersion > reader) {
    return unsound(name, "needs a reader of version {}, this is {}; use a newer honeycomb, or {}", header.neededVersion,
                   reader, kBuildAgain);
  }
  if (header.version == 0 || header.version + 1 < reader)
    return unsound(name, "is of version {}, which version {} no longer reads; {}", header.version, reader, kBuildAgain);
  return {};
}

Result<TableHeader> readHeader(std::span<const std::byte> bytes, const std::string& name, std::uint32_t reader) {
  TableHeader header;
  if (bytes.size() < sizeof(header)) return unsound(name, "ends within the header of a table file; {}", kBuildAgain);
  if (reinterpret_cast<std::uintptr_t>(bytes.data()) % alignof(double) != 0)
    return unsound(name, "begins at no multiple of {} bytes in memory; put it at one", alignof(double));
  std::memcpy(&header, bytes.data(), sizeof(header));
  if (header.magic != kTableMagic) return unsound(name, "is no table file (.hct); {}", kBuildAgain);
  // What is behind the version may mean something else in files of other versions.
  if (auto fits = checkVersion(header, name, reader); !fits) return tl::unexpected(fits.error());
  if (header.headerChecksum != checksum(bytes.first(offsetof(TableHeader, headerChecksum))))
    return unsound(name, "its header is damaged; {}", kBuildAgain);
  if (header.fileBytes != bytes.size())
    return unsound(name, "has {} bytes and should have {}; {}", bytes.size(), header.fileBytes, kBuildAgain);
  return header;
}

/// Sections follow each other, so that none overlap. `end`: of the section before.
Result<void> checkPlace(const TableEntry& entry, std::uint64_t end, std::uint64_t fileBytes, const std::string& name) {
  const bool sized =
      entry.elementBytes > 0 && entry.offset % kTableAlignment == 0 && entry.offset >= end && entry.offset <= fileBytes;
  if (!sized || entry.count > (fileBytes - entry.offset) / entry.elementBytes ||
      entry.count > std::uint64_t{std::numeric_limits<std::int32_t>::max()})
    return unsound(name, "section {} at byte {} doesn't lie in the file; {}", sectionName(entry), entry.offset,
                   kBuildAgain);
  return {};
}

}  // namespace

const TableEntry* TableDirectory::find(TableArray kind, std::uint32_t table) const {
  const auto found = places.find({static_cast<std::uint32_t>(kind), table});
  return found == places.end() ? nullptr : &entries[found->second];
}

std::string sectionName(const TableEntry& entry) {
  const std::string_view array = arrayName(entry.kind);
  if (array.empty()) return fmt::format("kind {} of table {}", entry.kind, entry.table);
  const auto kind = static_cast<TableArray>(entry.kind);
  const std::uint32_t t = entry.table;
  if (kind >= TableArray::levelCounts && kind <= TableArray::weightsSingle) {
    if (t < kLimitChild) return fmt::format("level {} {}", t, array);
    return t < kSharedSets ? fmt::format("child {}", array) : fmt::format("shared {} {}", t - kSharedSets, array);
  }
  if (kind >= TableArray::limitCounts && kind <= TableArray::limitWeightsSingle) {
    if (t >= kSharedLimits) return fmt::format("tiles' {}", array);
    if (t >= kSharedNormals) return fmt::format("normals {} {}", t - kSharedNormals, array);
    constexpr std::array<std::string_view, 3> kOf{"face", "vertex", "here"};
    return t < kOf.size() ? fmt::format("{} {}", kOf[t], array) : fmt::format("{} {}", array, t);
  }
  return t == 0 ? std::string(array) : fmt::format("{} {}", array, t);
}

Result<TableDirectory> readDirectory(std::span<const std::byte> bytes, const std::string& name, std::uint32_t reader) {
  const Result<TableHeader> header = readHeader(bytes, name, reader);
  if (!header) return tl::unexpected(header.error());
  if (header->sectionCount > (bytes.size() - sizeof(TableHeader)) / sizeof(TableEntry))
    return unsound(name, "ends within its directory; {}", kBuildAgain);
  const auto directory = bytes.subspan(sizeof(TableHeader), header->sectionCount * sizeof(TableEntry));
  if (checksum(directory) != header->directoryChecksum)
    return unsound(name, "its directory is damaged; {}", kBuildAgain);
  TableDirectory result{*header, {}, {}};
  std::uint64_t end = sizeof(TableHeader) + directory.size();
  for (std::size_t i = 0; i < header->sectionCount; ++i) {
    TableEntry entry;
    std::memcpy(&entry, directory.data() + i * sizeof(TableEntry), sizeof(entry));
    if (auto placed = checkPlace(entry, end, bytes.size(), name); !placed) return tl::unexpected(placed.error());
    end = entry.offset + entry.count * entry.elementBytes;
    if (arrayName(entry.kind).empty()) {
      if ((entry.flags & kOptionalSection) != 0) continue;
      return unsound(name, "section {} needs a reader of version {}, this is {}; use a newer honeycomb, or {}",
                     sectionName(entry), entry.neededVersion, reader, kBuildAgain);
    }
    if (!result.places.try_emplace({entry.kind, entry.table}, result.entries.size()).second)
      return unsound(name, "has section {} twice; {}", sectionName(entry), kBuildAgain);
    result.entries.push_back(entry);
  }
  return result;
}

}  // namespace honeycomb::Io
