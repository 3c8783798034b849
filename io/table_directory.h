#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "far/base/result.h"
#include "io/table_format.h"

namespace honeycomb::Io {

/// The header and the directory of a table file, proven: sections lie within the file, one behind the other, aligned.
struct TableDirectory {
  TableHeader header;
  std::vector<TableEntry> entries;  ///< those of kinds that this reader knows, in the order of the file

  /// The number of each entry, by kind and table.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> places;

  /// Null where there is no such section.
  const TableEntry* find(TableArray kind, std::uint32_t table) const;
};

/// Reads them, as a reader of version `reader` does: files of that version and the one before, and newer ones whose
/// writer says that it can; sections that it doesn't know are left out where their writer says that it may.
/// Errors: invalidFile. `name` stands for the file.
Result<TableDirectory> readDirectory(std::span<const std::byte> bytes, const std::string& name,
                                     std::uint32_t reader = kTableVersion);

/// "level 3 indices", "child weights".
std::string sectionName(const TableEntry& entry);

}  // namespace honeycomb::Io
