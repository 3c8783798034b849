#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "osd/vulkan/descriptor_sets.h"
#include "osd/vulkan/topology.h"

namespace honeycomb::Osd {

/// The push constants of shaders/connectivity.glsl, which says what they are.
struct TopologyPush {
  std::uint32_t count = 0;
  std::uint32_t rowLength = 0;
  std::uint32_t first = 0;
  std::uint32_t vertices = 0;
  std::uint32_t faces = 0;
  std::uint32_t halfEdges = 0;
  std::uint32_t parents = 0;
  std::uint32_t windowBegin = 0;
  std::uint32_t windowSize = 0;
  std::uint32_t value = 0;
  std::uint32_t shift = 0;
  std::uint32_t most = 0;
};
static_assert(sizeof(TopologyPush) <= sizeof(PushConstants), "the pipelines' layout has room for it");

/// What is wrong with a half-edge of the control mesh: as in shaders/connectivity.glsl.
enum class ControlDefect : std::uint32_t { none, face, vertex, open, twin, valence };

/// Numbers that one invocation of a sort or a scan takes, and the bits of a digit; as there.
constexpr std::uint32_t kTopologyPiece = 64;
constexpr std::uint32_t kTopologyDigit = 4;
inline std::uint32_t topologyPieces(std::uint32_t numbers) {
  return (numbers + kTopologyPiece - 1) / kTopologyPiece;
}
/// Counts of digits of that many keys.
inline std::uint32_t digitCounts(std::uint32_t keys) {
  return topologyPieces(keys) << kTopologyDigit;
}

/// Kernels that halve a problem again and again until one piece is left: sums or least values of pieces of pieces.
struct TopologyChain {
  std::uint32_t up = 0;     ///< the first of `depth` sets, from numbers to numbers of pieces
  std::uint32_t down = 0;   ///< of a scan: the first of depth + 1 sets, of numbers and of what stands before pieces
  std::uint32_t depth = 0;  ///< as the largest mesh wants it
};

/// Sets whose target is one window of a buffer after the other, each a page.
struct TopologyWindows {
  std::uint32_t first = 0;
  std::uint64_t numbers = 0;  ///< of the buffer
};

/// The arrays of one level.
struct TopologyLevel {
  VulkanBuffer vert, parents, twin;
  TopologyWindows vertWindows, parentWindows, twinWindows;
  std::uint32_t vertPage = 0;  ///< of the pages that twins are found with, the first of vert
};

/// All that recording needs: buffers, pipelines, descriptor sets. Immutable, but for what the device writes.
struct TopologyPasses {
  std::shared_ptr<const VulkanCore> core;
  std::shared_ptr<VulkanPipelines> pipelines;
  std::array<VkPipeline, kKernelCount> compiled{};  ///< by kernel, those of connectivity
  VulkanTopologyOptions options;
  VulkanBuffer work;         ///< what is kept from one kernel to the next
  VulkanBuffer faceOffsets;  ///< of the last level
  VulkanBuffer face;         ///< of the last level with links, else of level 1
  VulkanBuffer status;       ///< the least defect and, so many bytes from it, whether level 1 is complete
  std::uint64_t statusComplete = 0;
  std::vector<TopologyLevel> levels;  ///< from level 1
  DescriptorSets sets;
  std::uint32_t controlFaces = 0, levelFaces = 0, around = 0, turns = 0, places = 0, loops = 0;  ///< sets
  std::uint32_t sortCounts = 0, sortPlaces = 0;                                                  ///< one a digit
  std::uint32_t digits = 1;
  TopologyChain least, countScan, keyScan;
  TopologyWindows offsetWindows, faceWindows;

  /// Errors: outOfMemory, deviceLost.
  static Result<TopologyPasses> create(const VulkanEvaluator& evaluator, const VulkanControlMesh& mesh,
                                       const VulkanTopologyOptions& options);
  /// Level k of those there are, or null.
  const TopologyLevel* level(std::int32_t k) const {
    return k < 1 || k > options.levels ? nullptr : &levels[static_cast<std::size_t>(k - 1)];
  }
  /// Records everything; the counts have been checked.
  void record(VkCommandBuffer commands, const MeshCounts& control) const;
};

}  // namespace honeycomb::Osd
