#include <algorithm>

#include "far/base/index.h"
#include "io/table_file.h"

namespace honeycomb::Io {

namespace {

const TableSection* sectionOf(const TableFile& file, const std::string& name) {
  const auto found = std::ranges::find(file.sections(), name, &TableSection::name);
  return found == file.sections().end() ? nullptr : &*found;
}

/// The first element that differs; -1 if none does.
std::int64_t firstDifferent(const TableSection& a, const TableSection& b) {
  const auto [inA, inB] = std::ranges::mismatch(a.bytes, b.bytes);
  if (inA == a.bytes.end() && inB == b.bytes.end()) return -1;
  const std::int64_t elementBytes = std::ssize(a.bytes) / std::max<std::int64_t>(a.count, 1);
  return (inA - a.bytes.begin()) / std::max<std::int64_t>(elementBytes, 1);
}

}  // namespace

std::vector<TableDifference> differences(const TableFile& first, const TableFile& second) {
  std::vector<TableDifference> found;
  for (const TableSection& section : first.sections()) {
    const TableSection* other = sectionOf(second, section.name);
    if (other == nullptr) {
      found.push_back({section.name, -1, true, false});
      continue;
    }
    const std::int64_t element = firstDifferent(section, *other);
    if (element >= 0) found.push_back({section.name, element});
  }
  for (const TableSection& section : second.sections()) {
    if (sectionOf(first, section.name) == nullptr) found.push_back({section.name, -1, false, true});
  }
  return found;
}

}  // namespace honeycomb::Io
