#include "far/schemes/source_level.h"

#include <algorithm>
#include <numeric>

#include "far/base/index.h"

namespace honeycomb::Far {

void SourceLevel::addBarycentre(std::int32_t f, double weight, Row& row) const {
  const double share = weight / topology_.sides(f);
  if (const std::int32_t sum = sumPoint(f); sum >= 0) {
    row.push_back({sum, share});
    return;
  }
  for (const std::int32_t h : topology_.halfEdgesOf(f)) {
    row.push_back({topology_.vert(h), share});
  }
}

void SourceLevel::addCentral(std::int32_t f, double weight, Row& row) const {
  if (hasCentral()) {
    row.push_back({central(f), weight});
  } else {
    addBarycentre(f, weight, row);
  }
}

namespace {

/// Rows of up to this many entries are compared pair by pair: faster than any order of them.
constexpr std::size_t kShortRow = 32;

void mergeShort(Row& row) {
  auto kept = row.begin();
  for (auto entry = row.begin(); entry != row.end(); ++entry) {
    const auto first = std::find_if(row.begin(), kept, [&](const Weight& w) { return w.point == entry->point; });
    if (first == kept) {
      *kept++ = *entry;
    } else {
      first->weight += entry->weight;
    }
  }
  row.erase(kept, row.end());
}

}  // namespace

void mergeEntries(Row& row) {
  if (row.size() <= kShortRow) return mergeShort(row);
  std::vector<std::size_t> order(row.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return row[a].point < row[b].point; });
  std::vector<std::size_t> first(row.size());  // the first entry of each entry's point
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && row[order[i]].point == row[order[i - 1]].point;
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  std::size_t kept = 0;
  std::vector<std::size_t> place(row.size());
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (first[i] == i) {
      place[i] = kept;
      row[kept++] = row[i];
    } else {
      row[place[first[i]]].weight += row[i].weight;
    }
  }
  row.resize(kept);
}

}  // namespace honeycomb::Far
