#include "far/tables/normal_rule.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>

#include "far/base/bytes.h"
#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/tables/limit_table_builder.h"

namespace honeycomb::Far {

namespace {

/// Every so many'th, where there are too many for a tile.
void thinOut(std::vector<std::int32_t>& normals) {
  const std::size_t every = (normals.size() + kMostSummedNormals - 1) / kMostSummedNormals;
  if (every < 2) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < normals.size(); i += every) normals[kept++] = normals[i];
  normals.resize(kept);
}

}  // namespace

NormalRule::NormalRule(const Refinement& refinement, std::int32_t level)
    : refinement_(refinement),
      last_(level),
      level_(refinement.level(level)),
      before_(refinement.level(level - 1).topology) {
  firstNormals_.push_back(0);
  for (std::int32_t k = 0; k < level; ++k) {
    firstNormals_.push_back(firstNormals_.back() + refinement.level(k).topology.faceCount());
    born_.push_back(bornRuns(k));
  }
  trace();
}

/// Faces of level k live on from the level before where a whole face becomes a whole face of as many sides.
std::vector<std::uint8_t> NormalRule::bornRuns(std::int32_t k) const {
  const Topology& topology = refinement_.level(k).topology;
  std::vector<std::uint8_t> born;
  for (const FaceRun& run : topology.runs()) {
    if (k == 0 || run.kind != FaceKind::full || run.parent != FaceParent::face) {
      born.push_back(1);
      continue;
    }
    const Topology& parents = refinement_.level(k - 1).topology;
    std::atomic<bool> changed{false};
    Parallel::forEach(run.firstFace, run.firstFace + run.faceCount, [&](std::int64_t f) {
      const std::int32_t parent = topology.parents()[at(f)];
      const bool lives = parents.sides(parent) == run.sides && parents.run(parent).kind == FaceKind::full;
      if (!lives) changed.store(true, std::memory_order_relaxed);
    });
    born.push_back(changed ? 1 : 0);
  }
  return born;
}

void NormalRule::trace() {
  std::vector<std::int32_t> before;
  for (std::int32_t k = 0; k < last_; ++k) {
    const Topology& topology = refinement_.level(k).topology;
    std::vector<std::int32_t> here(at(topology.faceCount()));
    for (std::size_t r = 0; r < topology.runs().size(); ++r) {
      const FaceRun& run = topology.runs()[r];
      const bool born = born_[at(k)][r] != 0;
      Parallel::forEach(run.firstFace, run.firstFace + run.faceCount, [&](std::int64_t f) {
        here[at(f)] = born ? firstNormal(k) + static_cast<std::int32_t>(f) : before[at(topology.parents()[at(f)])];
      });
    }
    before = std::move(here);
  }
  normals_ = std::move(before);
}

LimitRows NormalRule::frames(std::int32_t k) const {
  const Level& level = refinement_.level(k);
  std::vector<FaceRun> runs;
  for (std::size_t r = 0; r < level.topology.runs().size(); ++r) {
    if (born_[at(k)][r] != 0) runs.push_back(level.topology.runs()[r]);
  }
  LimitRows rows = buildFaceFrames(level.points(), runs);
  for (std::int32_t& element : rows.elements) element += firstNormal(k);
  return rows;
}

/// Appends the normals of the faces at a vertex of level L - 1, unless they are too many: its edges may all have points
/// of their own, each of which would walk round it.
void NormalRule::appendAt(std::int32_t vertex, std::vector<std::int32_t>& normals) const {
  const std::size_t before = normals.size();
  for (const std::int32_t out : before_.halfEdgesFrom(vertex)) {
    if (normals.size() - before == kMostFacesOfVertex) return normals.resize(before);
    normals.push_back(normalOf(before_.face(out)));
  }
}

/// The normals of what the faces round a vertex were made from.
std::vector<std::int32_t> NormalRule::around(std::int32_t vertex) const {
  const Topology& topology = level_.topology;
  std::vector<std::int32_t> normals;
  if (vertex >= topology.vertexCount()) return normals;
  for (const std::int32_t h : topology.halfEdgesFrom(vertex)) {
    const std::int32_t face = topology.face(h);
    const std::int32_t parent = topology.parents()[at(face)];
    switch (topology.parentKind(face)) {
      case FaceParent::face:
        normals.push_back(normalOf(parent));
        break;
      case FaceParent::edge:
        normals.push_back(normalOf(before_.face(parent)));
        if (before_.twin(parent) >= 0) normals.push_back(normalOf(before_.face(before_.twin(parent))));
        break;
      case FaceParent::vertex:
        appendAt(parent, normals);
        break;
    }
  }
  thinOut(normals);
  return normals;
}

std::int64_t NormalTable::byteCount() const {
  std::int64_t total = bytes(offsets) + bytes(faces);
  for (const LimitRows& rows : frames) total += rows.byteCount();
  return total;
}

Result<NormalTable> buildNormalTable(const Refinement& refinement, std::int32_t level) {
  if (level < 1 || level > refinement.levelCount()) {
    return fail(ErrorCode::invalidOption,
                fmt::format("level {} is out of range; use 1 to {}", level, refinement.levelCount()));
  }
  const NormalRule rule(refinement, level);
  NormalTable table;
  table.level = level;
  table.faceNormals = rule.normalCount();
  for (std::int32_t k = 0; k < level; ++k) table.frames.push_back(rule.frames(k));
  table.offsets.resize(at(rule.pointCount()) + 1, 0);
  Parallel::forEach(0, rule.pointCount(), [&](std::int64_t v) {
    std::int32_t count = 0;
    rule.visit(static_cast<std::int32_t>(v), [&](std::int32_t) { ++count; });
    table.offsets[at(v)] = count;
  });
  table.faces.resize(at(Parallel::exclusiveScan(table.offsets)));
  Parallel::forEach(0, rule.pointCount(), [&](std::int64_t v) {
    std::int32_t next = table.offsets[at(v)];
    rule.visit(static_cast<std::int32_t>(v), [&](std::int32_t normal) { table.faces[at(next++)] = normal; });
  });
  return table;
}

}  // namespace honeycomb::Far
