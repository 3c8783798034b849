#include "tests/support/manifold_check.h"

#include <algorithm>
#include <map>
#include <set>

namespace honeycomb::Test {
namespace {

using EdgeEnds = std::pair<std::size_t, std::size_t>;

/// Directed edge -> the corner before it and the corner after it are found through its face.
std::map<EdgeEnds, std::size_t> edgesOf(const std::vector<Loop>& faces) {
  std::map<EdgeEnds, std::size_t> edges;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Loop& loop = faces[f];
    for (std::size_t i = 0; i < loop.size(); ++i) edges.insert({{loop[i], loop[(i + 1) % loop.size()]}, f});
  }
  return edges;
}

/// Do the corners at every vertex form one fan? Corner (before, v, after): the next one CCW starts at `before`.
bool hasBowTie(const std::vector<Loop>& faces) {
  std::map<std::size_t, std::map<std::size_t, std::size_t>> fans;  // vertex -> {after -> before}
  for (const Loop& loop : faces) {
    const std::size_t n = loop.size();
    for (std::size_t i = 0; i < n; ++i) fans[loop[i]][loop[(i + 1) % n]] = loop[(i + n - 1) % n];
  }
  for (const auto& [vertex, fan] : fans) {
    std::set<std::size_t> entered;
    for (const auto& [after, before] : fan) entered.insert(before);
    std::size_t start = fan.begin()->first;
    for (const auto& [after, before] : fan) {
      if (!entered.contains(after)) start = after;
    }
    std::size_t walked = 0;
    std::size_t at = start;
    do {
      const auto corner = fan.find(at);
      if (corner == fan.end()) break;
      ++walked;
      at = corner->second;
    } while (at != start);
    if (walked != fan.size()) return true;
  }
  return false;
}

}  // namespace

bool isManifold(const std::vector<Loop>& faces, std::string* why) {
  const auto no = [why](const char* reason) {
    if (why != nullptr) *why = reason;
    return false;
  };
  std::size_t cornerCount = 0;
  for (const Loop& loop : faces) {
    if (loop.size() < 3) return no("a face with fewer than three sides");
    if (std::set<std::size_t>(loop.begin(), loop.end()).size() != loop.size()) return no("a vertex twice in a face");
    cornerCount += loop.size();
  }
  if (edgesOf(faces).size() != cornerCount) return no("two faces on the same side of an edge");
  if (hasBowTie(faces)) return no("a bow-tie");
  return true;
}

std::int64_t eulerCharacteristic(const std::vector<Loop>& faces) {
  std::set<std::size_t> vertices;
  std::set<EdgeEnds> edges;
  for (const Loop& loop : faces) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      vertices.insert(loop[i]);
      edges.insert(std::minmax(loop[i], loop[(i + 1) % loop.size()]));
    }
  }
  return static_cast<std::int64_t>(vertices.size()) - static_cast<std::int64_t>(edges.size()) +
         static_cast<std::int64_t>(faces.size());
}

std::size_t boundaryEdgeCount(const std::vector<Loop>& faces) {
  const auto edges = edgesOf(faces);
  std::size_t count = 0;
  for (const auto& [edge, face] : edges) count += edges.contains({edge.second, edge.first}) ? 0 : 1;
  return count;
}

}  // namespace honeycomb::Test
