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

// Bytes a half-edge, as Far::refine counts them: what a split keeps besides its result, and the rows of the limits.
constexpr std::int64_t kSplitScratch = 4;
constexpr std::int64_t kLimitRows = 12;

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

std::vector<LevelSize> predictSizes(const Far::Topology& control, const Far::Scheme& scheme, std::int32_t levels,
                                    const RunShape& shape) {
  // The limit tables of a level lead to the points of the next.
  const std::vector<Far::Scheme> perLevel(at(levels) + (shape.normals ? 1 : 0), scheme);
  const std::vector<Far::LevelCounts> counts = Far::predict(control, perLevel);
  std::vector<LevelSize> sizes;
  std::int64_t tables = 0, pointsBefore = 0;
  for (std::size_t k = 0; k <= at(levels); ++k) {
    LevelSize size{counts[k], counts[k].vertices * 3 * shape.bytesPerNumber, 0};
    tables += size.counts.bytes;
    // An evaluator keeps the points of the two levels before the last.
    std::int64_t points = shape.framesAtOnce * (size.pointBytes + pointsBefore);
    std::int64_t limits = 0, scratch = kSplitScratch * size.counts.halfEdges;
    if (shape.normals) {
      const Far::LevelCounts& child = counts[k + 1];
      limits = child.bytes + kLimitRows * child.halfEdges;
      scratch = kSplitScratch * child.halfEdges;
      points += size.pointBytes + child.vertices * 3 * shape.bytesPerNumber;
    }
    size.runBytes = tables + limits + std::max(scratch, points);
    pointsBefore = size.pointBytes + (k == 0 ? 0 : sizes.back().pointBytes);
    sizes.push_back(size);
  }
  return sizes;
}

Result<void> checkSizes(std::span<const LevelSize> sizes, std::int64_t memory) {
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    const LevelSize& size = sizes[k];
    const auto level = static_cast<std::int64_t>(k);
    // An upper bound refuses nothing: a mesh that the boundary rule erodes may have fewer.
    if (size.counts.exact && size.counts.halfEdges > kMostHalfEdges)
      return fail(
          ErrorCode::tooLarge,
          fmt::format("level {} would have {} half-edges and take {}; 2^31 - 1 half-edges is the most a level can "
                      "have; {}",
                      k, grouped(size.counts.halfEdges), humanBytes(size.runBytes), advice(level)),
          level);
    if (size.runBytes > memory)
      return fail(ErrorCode::tooLarge,
                  fmt::format("level {} would take {}{} ({} bytes) of memory, {} is free; {}", k,
                              size.counts.exact ? "" : "up to ", humanBytes(size.runBytes), size.runBytes,
                              humanBytes(memory), advice(level)),
                  level);
  }
  return {};
}

}  // namespace honeycomb::Cli
