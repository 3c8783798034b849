#include "osd/vulkan/topology.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <utility>

#include "osd/vulkan/guard.h"
#include "osd/vulkan/stage_planner.h"
#include "osd/vulkan/topology_passes.h"

namespace honeycomb::Osd {

struct VulkanTopology::State {
  TopologyPasses passes;
};

MeshCounts zipCounts(MeshCounts control, std::int32_t levels) {
  MeshCounts counts = control;
  for (std::int32_t k = 0; k < levels; ++k) {
    counts = {counts.halfEdges, counts.faces + counts.vertices, 3 * counts.halfEdges};
  }
  return counts;
}

namespace {

constexpr std::int64_t kMostHalfEdges = std::numeric_limits<std::int32_t>::max();
/// Half-edges of a control mesh whose defects fit 32 bits.
constexpr std::int64_t kMostControl = std::int64_t{1} << 28U;

/// Could these be of a closed mesh?
Result<void> checkCounts(const MeshCounts& counts) {
  const bool sound = counts.vertices > 0 && counts.faces > 0 && counts.halfEdges % 2 == 0 &&
                     counts.halfEdges / 3 >= counts.faces && counts.halfEdges >= counts.vertices;
  if (sound) return {};
  return fail(ErrorCode::invalidOption,
              fmt::format("{} vertices, {} faces and {} half-edges: a closed mesh has two half-edges an edge, three or "
                          "more a face and one or more a vertex; give the numbers of the control mesh",
                          counts.vertices, counts.faces, counts.halfEdges));
}

Result<void> checkOptions(const VulkanTopologyOptions& options) {
  if (options.levels < 1 || options.maxValence < 1) {
    return fail(ErrorCode::invalidOption, fmt::format("{} levels of vertices of up to {} edges: both are 1 or more",
                                                      options.levels, options.maxValence));
  }
  if (auto sound = checkCounts(options.most); !sound) return sound;
  std::int64_t halfEdges = options.most.halfEdges;
  for (std::int32_t k = 0; k < options.levels && halfEdges <= kMostHalfEdges; ++k) halfEdges *= 3;
  if (halfEdges <= kMostHalfEdges && options.most.halfEdges <= kMostControl) return {};
  return fail(ErrorCode::tooLarge,
              fmt::format("{} levels of a control mesh with {} half-edges have more than 2^31 - 1: lower "
                          "VulkanTopologyOptions::levels or most",
                          options.levels, options.most.halfEdges));
}

/// Can the device bind what is read and written?
Result<void> checkDevice(const VulkanLimits& limits, const VulkanTopologyOptions& options) {
  const auto bytesOf = [&](std::int32_t level) {
    return static_cast<std::uint64_t>(zipCounts(options.most, level).halfEdges) * sizeof(std::uint32_t);
  };
  if (bytesOf(1) > limits.pageBytes) {
    return fail(
        ErrorCode::tooLarge,
        fmt::format("level 1 of a control mesh with {} half-edges takes {} bytes, this Vulkan device binds {} at "
                    "once: lower VulkanTopologyOptions::most, or refine on the CPU (Far::refine)",
                    options.most.halfEdges, bytesOf(1), limits.pageBytes));
  }
  const std::int32_t read = options.links ? options.levels : options.levels - 2;
  std::uint64_t pages = pagesOf(bytesOf(std::max(read, 0)), limits);
  if (options.links) pages += pagesOf(bytesOf(read - 1), limits);
  if (pages > kSourcePages) {
    return fail(ErrorCode::tooLarge,
                fmt::format("level {} has {} bytes, this Vulkan device reads {} at once: lower "
                            "VulkanTopologyOptions::levels, leave out links, or refine on the CPU (Far::refine)",
                            read, bytesOf(read), kSourcePages * limits.pageBytes));
  }
  Dispatch largest;
  return StagePlanner(limits, {}, {}).shape(largest, std::min(limits.pageNumbers(), bytesOf(options.levels) / 4));
}

Result<void> checkBuffers(const VulkanLimits& limits, const VulkanControlMesh& mesh, const MeshCounts& most) {
  struct Wanted {
    VulkanRange range;
    std::int64_t numbers;
    const char* what;
  };
  const std::array<Wanted, 3> buffers = {{{mesh.faceOffsets, std::int64_t{most.faces} + 1, "the faces' offsets"},
                                          {mesh.vert, most.halfEdges, "the half-edges' vertices"},
                                          {mesh.twin, most.halfEdges, "the half-edges' twins"}}};
  for (const Wanted& one : buffers) {
    const std::uint64_t needed = static_cast<std::uint64_t>(one.numbers) * sizeof(std::uint32_t);
    if (auto sound = checkRange(one.range, needed, limits.alignment, one.what); !sound) return sound;
  }
  return {};
}

/// What check() says of the least defect, a half-edge's.
Error defectError(ControlDefect kind, std::uint32_t h, std::int32_t maxValence) {
  const auto at = [h](const char* what) { return fmt::format("half-edge {} of the control mesh {}", h, what); };
  switch (kind) {
    case ControlDefect::face:
      return {ErrorCode::invalidMesh,
              fmt::format("the control mesh's face offsets, at half-edge or face {}, don't ascend from 0 to the number "
                          "of half-edges by 3 or more: write them so",
                          h),
              h};
    case ControlDefect::vertex:
      return {ErrorCode::invalidMesh, at("leaves a vertex there is none of: number vertices from 0"), h};
    case ControlDefect::open:
      return {
          ErrorCode::invalidMesh,
          at("has no twin: the device refines closed meshes; close it, or refine it on the CPU (Far::refine), which "
             "has rules for boundaries"),
          h};
    case ControlDefect::twin:
      return {ErrorCode::invalidMesh,
              at("and its twin aren't each other's, or don't join the same two vertices: match the half-edges anew"),
              h};
    default:
      return {ErrorCode::tooLarge,
              at("leaves a vertex of more edges than ") +
                  fmt::format("{}: raise VulkanTopologyOptions::maxValence", maxValence),
              h};
  }
}

}  // namespace

VulkanTopology::VulkanTopology(std::unique_ptr<State> state) : state_(std::move(state)) {}
VulkanTopology::VulkanTopology(VulkanTopology&&) noexcept = default;
VulkanTopology& VulkanTopology::operator=(VulkanTopology&&) noexcept = default;
VulkanTopology::~VulkanTopology() = default;

Result<VulkanTopology> VulkanTopology::create(const VulkanEvaluator& evaluator, const VulkanControlMesh& mesh,
                                              const VulkanTopologyOptions& options) {
  return guarded([&]() -> Result<VulkanTopology> {
    if (auto sound = checkOptions(options); !sound) return tl::unexpected(sound.error());
    const VulkanLimits& limits = evaluator.limits();
    if (auto sound = checkDevice(limits, options); !sound) return tl::unexpected(sound.error());
    if (auto sound = checkBuffers(limits, mesh, options.most); !sound) return tl::unexpected(sound.error());
    auto passes = TopologyPasses::create(evaluator, mesh, options);
    if (!passes) return tl::unexpected(passes.error());
    return VulkanTopology(std::make_unique<State>(State{std::move(*passes)}));
  });
}

Result<void> VulkanTopology::record(VkCommandBuffer commands, const MeshCounts& control) const {
  return guarded([&]() -> Result<void> {
    if (auto sound = checkCounts(control); !sound) return sound;
    const MeshCounts& most = options().most;
    if (control.vertices > most.vertices || control.faces > most.faces || control.halfEdges > most.halfEdges) {
      return fail(
          ErrorCode::tooLarge,
          fmt::format("a control mesh of {} vertices, {} faces and {} half-edges, with room for {}, {} and {}: "
                      "make another VulkanTopology with more VulkanTopologyOptions::most",
                      control.vertices, control.faces, control.halfEdges, most.vertices, most.faces, most.halfEdges));
    }
    state_->passes.record(commands, control);
    return {};
  });
}

Result<void> VulkanTopology::check() const {
  return guarded([&]() -> Result<void> {
    const std::span<std::byte> status = state_->passes.status.bytes();
    std::uint32_t defect = 0, complete = 0;
    std::memcpy(&defect, status.data(), sizeof(defect));
    std::memcpy(&complete, status.data() + state_->passes.statusComplete, sizeof(complete));
    if (complete == 0) {
      return fail(ErrorCode::invalidOption, "no control mesh has been refined yet: record, submit and wait first");
    }
    if (defect != std::numeric_limits<std::uint32_t>::max()) {
      return tl::unexpected(
          defectError(static_cast<ControlDefect>(defect % 8), defect / 8, state_->passes.options.maxValence));
    }
    if (complete == 1) return {};
    return fail(ErrorCode::invalidMesh,
                "a vertex of the control mesh has no faces, or several fans of them that meet in it alone: number only "
                "vertices that faces have, and give each fan a vertex of its own");
  });
}

const VulkanTopologyOptions& VulkanTopology::options() const {
  return state_->passes.options;
}

VulkanRange VulkanTopology::vert(std::int32_t level) const {
  const TopologyLevel* const found = state_->passes.level(level);
  return found == nullptr ? VulkanRange{} : found->vert.range();
}

VulkanRange VulkanTopology::parents(std::int32_t level) const {
  const TopologyLevel* const found = state_->passes.level(level);
  return found == nullptr ? VulkanRange{} : found->parents.range();
}

VulkanRange VulkanTopology::faceOffsets() const {
  return state_->passes.faceOffsets.range();
}

VulkanRange VulkanTopology::twin(std::int32_t level) const {
  const TopologyLevel* const found = options().links ? state_->passes.level(level) : nullptr;
  return found == nullptr ? VulkanRange{} : found->twin.range();
}

VulkanRange VulkanTopology::face() const {
  return options().links ? state_->passes.face.range() : VulkanRange{};
}

std::uint64_t VulkanTopology::byteCount() const {
  const TopologyPasses& passes = state_->passes;
  std::uint64_t bytes = passes.work.size() + passes.faceOffsets.size() + passes.face.size() + passes.status.size();
  for (const TopologyLevel& level : passes.levels)
    bytes += level.vert.size() + level.parents.size() + level.twin.size();
  return bytes;
}

}  // namespace honeycomb::Osd
