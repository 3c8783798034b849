#include <algorithm>

#include "osd/vulkan/commands.h"
#include "osd/vulkan/stage_planner.h"
#include "osd/vulkan/topology_passes.h"

namespace honeycomb::Osd {

namespace {

/// Records the dispatches of one control mesh.
class PassRecorder {
 public:
  PassRecorder(const TopologyPasses& passes, VkCommandBuffer commands, const MeshCounts& control)
      : passes_(passes), commands_(commands), control_(control), planner_(passes.core->limits, {}, {}) {
    push_.vertices = static_cast<std::uint32_t>(control.vertices);
    push_.faces = static_cast<std::uint32_t>(control.faces);
    push_.halfEdges = static_cast<std::uint32_t>(control.halfEdges);
  }

  void all() {
    barrier();
    faces(passes_.controlFaces, 0, push_.halfEdges, 1);
    for (std::int32_t k = 1; k <= passes_.options.levels; ++k) knownNumbers(k);
    barrier();
    push_.most = static_cast<std::uint32_t>(passes_.options.maxValence);
    step(Kernel::zipAround, passes_.around, push_.halfEdges);
    step(Kernel::zipTurns, passes_.turns, push_.halfEdges);
    findLeastDefect();
    sortVertices();
    step(Kernel::zipPlaces, passes_.places, push_.vertices);
    run(Kernel::zipLoops, passes_.loops, push_.vertices);
    faces(passes_.levelFaces, push_.halfEdges, 2 * push_.halfEdges, 0);
    // A level is made of what the last but one before it has.
    for (std::int32_t k = 2; k <= passes_.options.levels; ++k) {
      if (k % 2 == 0) barrier();
      hexagons(k);
    }
    if (passes_.options.links) {
      barrier();
      for (std::int32_t k = 1; k <= passes_.options.levels; ++k) twins(k);
    }
    const VkPipelineStageFlags readers = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_HOST_BIT;
    const VkAccessFlags reads = VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_HOST_READ_BIT;
    memoryBarrier(*passes_.core, commands_, {VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_WRITE_BIT},
                  {readers, reads});
  }

 private:
  void barrier() const {
    if (passes_.core->options.leaveOutBarriers) return;
    memoryBarrier(*passes_.core, commands_, {VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_WRITE_BIT},
                  {VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT});
  }

  void run(Kernel kernel, std::uint32_t set, std::uint32_t items) {
    if (items == 0) return;
    Dispatch shaped;
    // create() has tried the largest dispatch there is room for.
    if (!planner_.shape(shaped, items)) return;
    TopologyPush push = push_;
    push.count = items;
    push.rowLength = shaped.push.rowLength;
    const VulkanFunctions& vk = passes_.core->vk();
    const VkPipelineLayout layout = passes_.pipelines->layout();
    vk.vkCmdBindPipeline(commands_, VK_PIPELINE_BIND_POINT_COMPUTE,
                         passes_.pipelines->current(passes_.compiled[static_cast<std::size_t>(kernel)]));
    vk.vkCmdBindDescriptorSets(commands_, VK_PIPELINE_BIND_POINT_COMPUTE, layout, 0, 1, &passes_.sets.sets[set], 0,
                               nullptr);
    vk.vkCmdPushConstants(commands_, layout, VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(push), &push);
    vk.vkCmdDispatch(commands_, shaped.groups, shaped.groupRows, 1);
  }

  void step(Kernel kernel, std::uint32_t set, std::uint32_t items) {
    run(kernel, set, items);
    barrier();
  }

  /// The faces of half-edges first .. first + count - 1.
  void faces(std::uint32_t set, std::uint32_t first, std::uint32_t count, std::uint32_t control) {
    push_.first = first;
    push_.value = control;
    run(Kernel::zipFaceOf, set, count);
  }

  /// Calls visit(set, begin, end) for each window of numbers begin .. end - 1 of a buffer.
  template <class Visit>
  void forWindows(const TopologyWindows& windows, std::uint64_t begin, std::uint64_t end, const Visit& visit) {
    const std::uint64_t page = passes_.core->limits.pageNumbers();
    for (std::uint64_t w = begin / page; w * page < end; ++w) {
      push_.windowBegin = static_cast<std::uint32_t>(w * page);
      push_.windowSize = static_cast<std::uint32_t>(std::min(page, windows.numbers - w * page));
      visit(windows.first + static_cast<std::uint32_t>(w), std::max(begin, w * page), std::min(end, (w + 1) * page));
    }
  }

  /// What numbers begin .. end - 1 of a buffer are to be: `each` times `value`, then `each` times `step` more, and so
  /// on.
  struct Ramp {
    std::int32_t value = 0;
    std::uint32_t step = 1, each = 1;  // 1 or 6
  };
  void numbers(const TopologyWindows& windows, std::int64_t begin, std::int64_t end, const Ramp& ramp) {
    push_.parents = static_cast<std::uint32_t>(begin);
    push_.value = static_cast<std::uint32_t>(ramp.value);
    push_.shift = ramp.step;
    push_.most = ramp.each;
    forNumbers(Kernel::zipNumbers, windows, begin, end);
  }

  /// Runs a kernel for each of the numbers begin .. end - 1 of a buffer.
  void forNumbers(Kernel kernel, const TopologyWindows& windows, std::int64_t begin, std::int64_t end) {
    forWindows(windows, static_cast<std::uint64_t>(begin), static_cast<std::uint64_t>(end),
               [&](std::uint32_t set, std::uint64_t first, std::uint64_t last) {
                 push_.first = static_cast<std::uint32_t>(first);
                 run(kernel, set, static_cast<std::uint32_t>(last - first));
               });
  }

  /// What follows of level k from where it stands.
  void knownNumbers(std::int32_t k) {
    const TopologyLevel& level = passes_.levels[static_cast<std::size_t>(k - 1)];
    const MeshCounts before = zipCounts(control_, k - 1), counts = zipCounts(control_, k);
    numbers(level.vertWindows, 0, counts.vertices, {});
    numbers(level.parentWindows, 0, before.faces, {});
    if (k == 1) return;
    numbers(level.parentWindows, before.faces, counts.faces, {});
    // The first of these faces begins where the last one before it ends, which is there.
    numbers(passes_.offsetWindows, std::int64_t{before.faces} + 1, std::int64_t{counts.faces} + 1,
            {.value = before.halfEdges + 6, .step = 6});
    if (!passes_.options.links) return;
    numbers(passes_.faceWindows, before.halfEdges, counts.halfEdges, {.value = before.faces, .each = 6});
  }

  void twins(std::int32_t k) {
    const TopologyLevel& level = passes_.levels[static_cast<std::size_t>(k - 1)];
    push_.parents = static_cast<std::uint32_t>(zipCounts(control_, k - 1).halfEdges);
    push_.value = level.vertPage;
    forNumbers(Kernel::zipTwins, level.twinWindows, 0, zipCounts(control_, k).halfEdges);
  }

  void pieces(Kernel kernel, std::uint32_t set, std::uint32_t numbers) {
    push_.value = numbers;
    step(kernel, set, topologyPieces(numbers));
  }

  void findLeastDefect() {
    std::uint32_t n = 2 * push_.halfEdges;
    for (std::uint32_t i = 0; i < passes_.least.depth; ++i, n = topologyPieces(n)) {
      pieces(Kernel::least, passes_.least.up + i, n);
    }
  }

  void scan(const TopologyChain& chain, std::uint32_t numbers) {
    std::array<std::uint32_t, 7> counts{numbers};  // 64^6 numbers are more than there can be
    for (std::uint32_t i = 0; i < chain.depth; ++i) {
      pieces(Kernel::scanSums, chain.up + i, counts[i]);
      counts[i + 1] = topologyPieces(counts[i]);
    }
    for (std::uint32_t i = chain.depth + 1; i-- > 0;) pieces(Kernel::scanPieces, chain.down + i, counts[i]);
  }

  void sortVertices() {
    for (std::uint32_t d = 0; d < passes_.digits; ++d) {
      push_.shift = d * kTopologyDigit;
      pieces(Kernel::sortCounts, passes_.sortCounts + d, push_.vertices);
      scan(passes_.countScan, digitCounts(push_.vertices));
      pieces(Kernel::sortPlaces, passes_.sortPlaces + d, push_.vertices);
    }
    scan(passes_.keyScan, push_.vertices);
  }

  void hexagons(std::int32_t k) {
    const std::int64_t first = zipCounts(control_, k - 1).halfEdges;
    const std::int64_t end = zipCounts(control_, k).halfEdges;
    push_.parents = static_cast<std::uint32_t>(zipCounts(control_, k - 2).halfEdges);
    forWindows(passes_.levels[static_cast<std::size_t>(k - 1)].vertWindows, static_cast<std::uint64_t>(first),
               static_cast<std::uint64_t>(end), [&](std::uint32_t set, std::uint64_t from, std::uint64_t to) {
                 const auto lowest = static_cast<std::uint64_t>(first);
                 push_.first = static_cast<std::uint32_t>((from - lowest) / 6);
                 const auto last = static_cast<std::uint32_t>((to - lowest + 5) / 6);
                 run(Kernel::zipHexagons, set, last - push_.first);
               });
  }

  const TopologyPasses& passes_;
  VkCommandBuffer commands_;
  MeshCounts control_;
  StagePlanner planner_;
  TopologyPush push_;
};

}  // namespace

void TopologyPasses::record(VkCommandBuffer commands, const MeshCounts& control) const {
  PassRecorder(*this, commands, control).all();
}

}  // namespace honeycomb::Osd
