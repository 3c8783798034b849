#include "apps/cli/memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <limits>

#include "apps/cli/console.h"
#include "far/base/index.h"

namespace honeycomb::Cli {
namespace {

// Left to the program itself, its libraries and the page cache of the files it works on.
constexpr std::int64_t kMargin = 128'000'000;

// Bytes of a vertex in Far::NormalTable: its offset, four normals. Besides the table: the vertex's normal; those of
// faces and the points of the levels before, which are as much again.
constexpr std::int64_t kFastNormalRow = 4 + 4 * 4;

std::string advice(std::int64_t level) {
  return level > 1 ? fmt::format("use --levels {} or less", level - 1) : "the mesh is too large to refine here";
}

}  // namespace

std::int64_t availableMemory() {
  std::ifstream file("/proc/meminfo");
  std::string key, unit;
  for (std::int64_t kilobytes = 0; file >> key >> kilobytes; std::getline(file, unit))
    if (key == "MemAvailable:") return std::max<std::int64_t>(kilobytes * 1024 - kMargin, 0);
  return std::numeric_limits<std::int64_t>::max();
}

std::vector<LevelSize> predictSizes(const Far::Topology& control, const SchemeChain& chain, const RunShape& shape) {
  // The limit tables of a level lead to the points of the next.
  std::vector<Far::Scheme> steps = chain.steps;
  if (shape.normals && !steps.empty()) steps.push_back(steps.back());
  std::vector<Far::LevelCounts> counts = Far::predict(control, steps);
  if (shape.centralPoints) counts.front().points += counts.front().faces;
  const std::int64_t pointSize = std::int64_t{3} * shape.bytesPerNumber;
  std::vector<LevelSize> sizes;
  std::int64_t pointsBefore = 0;
  for (std::size_t k = 0; k <= chain.steps.size(); ++k) {
    LevelSize size{counts[k], chain.levelOf[k], k == 0 ? "" : chain.steps[k - 1].name, counts[k].points * pointSize, 0};
    const bool limits = k + 1 < counts.size() && shape.normals;
    const Far::BuildBytes build = Far::buildBytes(std::span(counts).first(k + (limits ? 2 : 1)), limits);
    // An evaluator keeps the points of the two levels before the last.
    std::int64_t points = shape.framesAtOnce * (size.pointBytes + pointsBefore);
    if (limits) points += (counts[k].vertices + counts[k + 1].points) * pointSize;
    if (shape.fastNormals) {
      points += counts[k].points * (kFastNormalRow + 2 * pointSize) + counts[k].links;
      if (k > 0) points += counts[k - 1].links;
    }
    size.runBytes = build.tables + std::max(build.scratch, points);
    pointsBefore = size.pointBytes + (k == 0 ? 0 : sizes.back().pointBytes);
    sizes.push_back(std::move(size));
  }
  return sizes;
}

Result<void> checkSizes(std::span<const LevelSize> sizes, std::int64_t memory) {
  for (const LevelSize& size : sizes) {
    const std::int64_t level = size.level;
    // An upper bound refuses nothing: a mesh that the boundary rule erodes may have fewer.
    if (size.counts.exact && size.counts.halfEdges > kMostHalfEdges)
      return fail(
          ErrorCode::tooLarge,
          fmt::format(
              "level {} would have {} half-edges and take {} ({} bytes); 2^31 - 1 half-edges is the most a level can "
              "have; {}",
              level, grouped(size.counts.halfEdges), humanBytes(size.runBytes), size.runBytes, advice(level)),
          level);
    if (size.runBytes > memory)
      return fail(ErrorCode::tooLarge,
                  fmt::format("level {} would take {}{} ({} bytes) of memory, {} is free; {}", level,
                              size.counts.exact ? "" : "up to ", humanBytes(size.runBytes), size.runBytes,
                              humanBytes(memory), advice(level)),
                  level);
  }
  return {};
}

Result<void> checkChain(const Far::Topology& control, const SchemeChain& chain) {
  return checkSizes(predictSizes(control, chain, RunShape{}), availableMemory());
}

}  // namespace honeycomb::Cli
