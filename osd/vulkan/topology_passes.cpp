#include "osd/vulkan/topology_passes.h"

#include <algorithm>
#include <bit>
#include <initializer_list>
#include <utility>

namespace honeycomb::Osd {

namespace {

constexpr std::uint64_t kNumber = sizeof(std::uint32_t);

/// What a set binds: pages of one buffer, and a range for each slot from binding 1; size 0: nothing.
struct BoundKernel {
  VulkanRange paged, pagedToo;  ///< the second behind the first
  std::array<VulkanRange, kSlotCount> slots{};
};

/// Puts TopologyPasses together: buffers first, then the sets that bind them.
class PassBuilder {
 public:
  PassBuilder(const VulkanEvaluator& evaluator, const VulkanControlMesh& mesh, const VulkanTopologyOptions& options)
      : mesh_(mesh) {
    passes_.core = evaluator.core();
    passes_.pipelines = evaluator.pipelines();
    passes_.options = options;
    halfEdges_ = static_cast<std::uint64_t>(options.most.halfEdges);
    vertices_ = static_cast<std::uint64_t>(options.most.vertices);
    const auto valence = static_cast<std::uint32_t>(options.maxValence);
    passes_.digits = (static_cast<std::uint32_t>(std::bit_width(valence)) + kTopologyDigit - 1) / kTopologyDigit;
  }

  Result<TopologyPasses> build() {
    if (auto made = makeLevels(); !made) return tl::unexpected(made.error());
    if (auto made = makeWork(); !made) return tl::unexpected(made.error());
    bindControl();
    bindSort();
    bindLevels();
    if (auto made = makeSets(); !made) return tl::unexpected(made.error());
    if (auto made = compile(); !made) return tl::unexpected(made.error());
    return std::move(passes_);
  }

 private:
  /// Sections of the work buffer, in bytes.
  struct Work {
    VulkanRange corner, around, defects, outgoing, valence, place, counts, countPlaces, cornersBefore;
    std::array<VulkanRange, 2> keys, order;
    std::vector<VulkanRange> least, sums, before;  ///< of pieces, of pieces of pieces, ...
  };

  static std::uint64_t aligned(std::uint64_t bytes, std::uint64_t alignment) {
    return (bytes + alignment - 1) / alignment * alignment;
  }
  /// The next section of so many numbers; its buffer isn't there yet.
  VulkanRange section(std::uint64_t numbers) {
    const VulkanRange range{VK_NULL_HANDLE, workBytes_, numbers * kNumber};
    workBytes_ += aligned(range.size, passes_.core->limits.alignment);
    return range;
  }
  /// Sections for the pieces of so many numbers, of these pieces, and so on until one is left.
  std::vector<VulkanRange> pieceSections(std::uint64_t numbers) {
    std::vector<VulkanRange> sections;
    for (auto n = static_cast<std::uint32_t>(numbers); n > kTopologyPiece;) {
      n = topologyPieces(n);
      sections.push_back(section(n));
    }
    return sections;
  }

  Result<void> makeLevels();
  Result<void> makeWork();
  Result<VulkanBuffer> makeArray(std::uint64_t numbers) const;
  void bindControl();
  void bindSort();
  void bindLevels();
  std::uint32_t bind(std::initializer_list<VulkanRange> slots, VulkanRange paged = {}, VulkanRange pagedToo = {});
  TopologyChain bindScan(VulkanRange numbers, VulkanRange scanned);
  TopologyWindows bindWindows(const VulkanBuffer& target, VulkanRange paged = {}, VulkanRange pagedToo = {});
  Result<void> makeSets();
  void writeSet(VkDescriptorSet set, const BoundKernel& kernel) const;
  VkDescriptorBufferInfo infoOf(const VulkanRange& range) const;
  Result<void> compile();

  const VulkanControlMesh& mesh_;
  TopologyPasses passes_;
  std::uint64_t halfEdges_ = 0, vertices_ = 0, workBytes_ = 0;
  Work work_;
  std::vector<BoundKernel> bound_;
};

Result<VulkanBuffer> PassBuilder::makeArray(std::uint64_t numbers) const {
  constexpr VkBufferUsageFlags kUsage =
      VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_INDEX_BUFFER_BIT;
  return VulkanBuffer::create(passes_.core, numbers * kNumber, kUsage, MemoryUse::device);
}

Result<void> PassBuilder::makeLevels() {
  const MeshCounts& most = passes_.options.most;
  for (std::int32_t k = 1; k <= passes_.options.levels; ++k) {
    const MeshCounts counts = zipCounts(most, k);
    TopologyLevel& level = passes_.levels.emplace_back();
    auto vert = makeArray(static_cast<std::uint64_t>(counts.halfEdges));
    if (!vert) return tl::unexpected(vert.error());
    level.vert = std::move(*vert);
    auto parents = makeArray(static_cast<std::uint64_t>(counts.faces));
    if (!parents) return tl::unexpected(parents.error());
    level.parents = std::move(*parents);
    if (!passes_.options.links) continue;
    auto twin = makeArray(static_cast<std::uint64_t>(counts.halfEdges));
    if (!twin) return tl::unexpected(twin.error());
    level.twin = std::move(*twin);
  }
  auto offsets = makeArray(static_cast<std::uint64_t>(zipCounts(most, passes_.options.levels).faces) + 1);
  if (!offsets) return tl::unexpected(offsets.error());
  passes_.faceOffsets = std::move(*offsets);
  const std::int32_t faced = passes_.options.links ? passes_.options.levels : 1;
  auto face = makeArray(static_cast<std::uint64_t>(zipCounts(most, faced).halfEdges));
  if (!face) return tl::unexpected(face.error());
  passes_.face = std::move(*face);
  return {};
}

Result<void> PassBuilder::makeWork() {
  const std::uint64_t counts = digitCounts(static_cast<std::uint32_t>(vertices_));
  work_ = {.corner = section(halfEdges_),
           .around = section(halfEdges_),
           .defects = section(2 * halfEdges_),
           .outgoing = section(vertices_),
           .valence = section(vertices_),
           .place = section(vertices_),
           .counts = section(counts),
           .countPlaces = section(counts),
           .cornersBefore = section(vertices_),
           .keys = {section(vertices_), section(vertices_)},
           .order = {section(vertices_), section(vertices_)},
           .least = pieceSections(2 * halfEdges_),
           .sums = pieceSections(std::max(counts, vertices_)),
           .before = pieceSections(std::max(counts, vertices_))};
  auto buffer = VulkanBuffer::create(passes_.core, workBytes_, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, MemoryUse::device);
  if (!buffer) return tl::unexpected(buffer.error());
  passes_.work = std::move(*buffer);
  passes_.statusComplete = passes_.core->limits.alignment;
  auto status = VulkanBuffer::create(passes_.core, passes_.statusComplete + kNumber, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                                     MemoryUse::readback);
  if (!status) return tl::unexpected(status.error());
  passes_.status = std::move(*status);
  std::ranges::fill(passes_.status.bytes(), std::byte{0});
  return {};
}

// Sections have no buffer of their own; what is left out is bound to the work buffer's first page.
VkDescriptorBufferInfo PassBuilder::infoOf(const VulkanRange& range) const {
  const std::uint64_t page = passes_.core->limits.pageBytes;
  if (range.size == 0) return {passes_.work.handle(), 0, std::min(page, passes_.work.size())};
  const VkBuffer buffer = range.buffer == VK_NULL_HANDLE ? passes_.work.handle() : range.buffer;
  return {buffer, range.offset, std::min(page, range.size)};
}

std::uint32_t PassBuilder::bind(std::initializer_list<VulkanRange> slots, VulkanRange paged, VulkanRange pagedToo) {
  BoundKernel& kernel = bound_.emplace_back();
  kernel.paged = paged;
  kernel.pagedToo = pagedToo;
  std::ranges::copy(slots, kernel.slots.begin());
  return static_cast<std::uint32_t>(bound_.size() - 1);
}

void PassBuilder::bindControl() {
  const VulkanRange offsets = passes_.faceOffsets.range();
  const VulkanRange complete{passes_.status.handle(), passes_.statusComplete, kNumber};
  passes_.controlFaces =
      bind({mesh_.faceOffsets, passes_.face.range(), offsets, work_.valence, complete, work_.outgoing});
  // The same kernel, which copies no offsets then and sets no vertices: what is bound for these isn't touched.
  passes_.levelFaces = bind({offsets, passes_.face.range(), work_.keys[0], work_.keys[0], complete, work_.keys[0]});
  passes_.around = bind({mesh_.vert, mesh_.twin, mesh_.faceOffsets, passes_.face.range(), work_.around, work_.defects});
  passes_.turns = bind({mesh_.vert, work_.around, work_.outgoing, work_.valence, work_.defects});
  std::vector<VulkanRange> chain{work_.defects};
  chain.insert(chain.end(), work_.least.begin(), work_.least.end());
  chain.push_back({passes_.status.handle(), 0, kNumber});
  passes_.least.depth = static_cast<std::uint32_t>(chain.size() - 1);
  passes_.least.up = static_cast<std::uint32_t>(bound_.size());
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) bind({chain[i], chain[i + 1]});
}

TopologyChain PassBuilder::bindScan(VulkanRange numbers, VulkanRange scanned) {
  const auto chained = [](VulkanRange first, const std::vector<VulkanRange>& pieces) {
    std::vector<VulkanRange> chain{first};
    chain.insert(chain.end(), pieces.begin(), pieces.end());
    return chain;
  };
  const std::vector<VulkanRange> sums = chained(numbers, work_.sums), before = chained(scanned, work_.before);
  TopologyChain chain;
  chain.depth = static_cast<std::uint32_t>(work_.sums.size());
  chain.up = static_cast<std::uint32_t>(bound_.size());
  for (std::size_t i = 0; i < chain.depth; ++i) bind({sums[i], sums[i + 1]});
  chain.down = static_cast<std::uint32_t>(bound_.size());
  for (std::size_t i = 0; i <= chain.depth; ++i) {
    bind({sums[i], i == chain.depth ? VulkanRange{} : before[i + 1], before[i]});
  }
  return chain;
}

void PassBuilder::bindSort() {
  const auto keysOf = [this](std::uint32_t digit) { return digit == 0 ? work_.valence : work_.keys[digit % 2]; };
  passes_.sortCounts = static_cast<std::uint32_t>(bound_.size());
  for (std::uint32_t d = 0; d < passes_.digits; ++d) bind({keysOf(d), work_.counts});
  passes_.sortPlaces = static_cast<std::uint32_t>(bound_.size());
  for (std::uint32_t d = 0; d < passes_.digits; ++d) {
    const std::uint32_t to = (d + 1) % 2;
    bind({keysOf(d), work_.order[d % 2], work_.countPlaces, work_.keys[to], work_.order[to]});
  }
  const std::uint32_t sorted = passes_.digits % 2;
  passes_.countScan = bindScan(work_.counts, work_.countPlaces);
  passes_.keyScan = bindScan(work_.keys[sorted], work_.cornersBefore);
  const TopologyLevel& first = passes_.levels.front();
  passes_.places = bind({work_.order[sorted], work_.keys[sorted], work_.cornersBefore, first.parents.range(),
                         passes_.faceOffsets.range(), work_.place});
  passes_.loops = bind({work_.outgoing, work_.around, work_.place, mesh_.twin, first.vert.range(), work_.corner});
}

TopologyWindows PassBuilder::bindWindows(const VulkanBuffer& target, VulkanRange paged, VulkanRange pagedToo) {
  const std::uint64_t page = passes_.core->limits.pageBytes;
  const TopologyWindows windows{static_cast<std::uint32_t>(bound_.size()), target.size() / kNumber};
  // Of what follows from where it stands nothing is read.
  const VulkanRange face = paged.size > 0 ? passes_.face.range() : VulkanRange{};
  const VulkanRange offsets = paged.size > 0 ? passes_.faceOffsets.range() : VulkanRange{};
  for (std::uint64_t begin = 0; begin < target.size(); begin += page) {
    bind({face, offsets, {target.handle(), begin, std::min(page, target.size() - begin)}}, paged, pagedToo);
  }
  return windows;
}

void PassBuilder::bindLevels() {
  // Where C stands follows from vert of the level before; of the control mesh it was stored. Level k + 1 is made by
  // that of level k, the twins of level k + 1 are found by its own.
  const auto before = [this](std::size_t k) { return k == 0 ? work_.corner : passes_.levels[k - 1].vert.range(); };
  for (std::size_t k = 0; k < passes_.levels.size(); ++k) {
    TopologyLevel& level = passes_.levels[k];
    level.vertWindows = bindWindows(level.vert, k == 0 ? VulkanRange{} : before(k - 1));
    level.parentWindows = bindWindows(level.parents);
    if (!passes_.options.links) continue;
    level.vertPage = static_cast<std::uint32_t>(pagesOf(before(k).size, passes_.core->limits));
    level.twinWindows = bindWindows(level.twin, before(k), level.vert.range());
  }
  passes_.offsetWindows = bindWindows(passes_.faceOffsets);
  passes_.faceWindows = bindWindows(passes_.face);
}

Result<void> PassBuilder::makeSets() {
  auto sets =
      DescriptorSets::create(*passes_.core, passes_.pipelines->setLayout(), static_cast<std::uint32_t>(bound_.size()));
  if (!sets) return tl::unexpected(sets.error());
  passes_.sets = std::move(*sets);
  for (std::size_t i = 0; i < bound_.size(); ++i) writeSet(passes_.sets.sets[i], bound_[i]);
  return {};
}

void PassBuilder::writeSet(VkDescriptorSet set, const BoundKernel& kernel) const {
  const std::uint64_t page = passes_.core->limits.pageBytes;
  std::array<VkDescriptorBufferInfo, kSourcePages + kSlotCount> buffers{};
  const std::uint64_t second = pagesOf(kernel.paged.size, passes_.core->limits);
  for (std::uint32_t i = 0; i < kSourcePages; ++i) {
    VulkanRange range = i < second ? kernel.paged : kernel.pagedToo;
    const std::uint64_t begin = (i < second ? i : i - second) * page;
    // Pages behind the last are bound to the first.
    if (begin >= range.size) {
      buffers[i] = infoOf(kernel.paged);
      continue;
    }
    range.offset += begin;
    range.size -= begin;
    buffers[i] = infoOf(range);
  }
  for (std::uint32_t i = 0; i < kSlotCount; ++i) buffers[kSourcePages + i] = infoOf(kernel.slots[i]);
  std::array<VkWriteDescriptorSet, 2> writes{};
  for (std::uint32_t i = 0; i < writes.size(); ++i) {
    writes[i].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    writes[i].dstSet = set;
    writes[i].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    writes[i].dstBinding = i;
    writes[i].descriptorCount = i == 0 ? kSourcePages : kSlotCount;  // one binding runs over into the next
    writes[i].pBufferInfo = &buffers[i * kSourcePages];
  }
  passes_.core->vk().vkUpdateDescriptorSets(passes_.core->device.device, static_cast<std::uint32_t>(writes.size()),
                                            writes.data(), 0, nullptr);
}

Result<void> PassBuilder::compile() {
  Specialization specialization;
  const auto shift = static_cast<std::uint32_t>(std::bit_width(passes_.core->limits.pageNumbers()) - 1);
  // Read at random places are, without links, the levels up to the last but one before the last.
  const auto last = static_cast<std::uint64_t>(zipCounts(passes_.options.most, passes_.options.levels).halfEdges);
  const std::uint64_t read = passes_.options.links ? last : last / 9;
  if (read > passes_.core->limits.pageNumbers()) specialization.pageShift = shift;
  for (auto k = static_cast<std::uint32_t>(Kernel::zipFaceOf); k < kKernelCount; ++k) {
    if (static_cast<Kernel>(k) == Kernel::zipTwins && !passes_.options.links) continue;
    const auto pipeline = passes_.pipelines->get(static_cast<Kernel>(k), specialization);
    if (!pipeline) return tl::unexpected(pipeline.error());
    passes_.compiled[k] = *pipeline;
  }
  return {};
}

}  // namespace

Result<TopologyPasses> TopologyPasses::create(const VulkanEvaluator& evaluator, const VulkanControlMesh& mesh,
                                              const VulkanTopologyOptions& options) {
  return PassBuilder(evaluator, mesh, options).build();
}

}  // namespace honeycomb::Osd
