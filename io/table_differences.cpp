#include <algorithm>
#include <map>
#include <string_view>

#include "far/base/index.h"
#include "io/table_file.h"

namespace honeycomb::Io {

namespace {

using SectionsByName = std::map<std::string_view, const TableSection*>;

SectionsByName byName(const TableFile& file) {
  SectionsByName sections;
  for (const TableSection& section : file.sections()) sections.emplace(section.name, &section);
  return sections;
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
  const SectionsByName ofFirst = byName(first), ofSecond = byName(second);
  for (const TableSection& section : first.sections()) {
    const auto other = ofSecond.find(section.name);
    if (other == ofSecond.end()) {
      found.push_back({section.name, -1, true, false});
      continue;
    }
    const std::int64_t element = firstDifferent(section, *other->second);
    if (element >= 0) found.push_back({section.name, element});
  }
  for (const TableSection& section : second.sections()) {
    if (!ofFirst.contains(section.name)) found.push_back({section.name, -1, false, true});
  }
  return found;
}

}  // namespace honeycomb::Io
