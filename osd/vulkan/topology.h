#pragma once

#include <cstdint>
#include <memory>

#include "far/base/result.h"
#include "osd/vulkan/evaluator.h"
#include "osd/vulkan/memory.h"

namespace honeycomb::Osd {

/// The numbers of vertices, faces and half-edges of a closed mesh.
struct MeshCounts {
  std::int32_t vertices = 0, faces = 0, halfEdges = 0;
  bool operator==(const MeshCounts&) const = default;
};

/// The same after that many steps of zip, of at most 2^31 - 1 half-edges: V' = H, F' = F + V, H' = 3H each.
MeshCounts zipCounts(MeshCounts control, std::int32_t levels);

/// The half-edges of a control mesh in buffers with VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, 32-bit integers, packed. The
/// half-edges of a face stand one after the other, in the order of its loop, counter-clockwise seen from outside; those
/// of face f are faceOffsets[f] .. faceOffsets[f + 1] - 1. Only closed meshes: every half-edge has a twin.
struct VulkanControlMesh {
  VulkanRange faceOffsets{};  ///< faces + 1 numbers, from 0 to the number of half-edges; a face has 3 sides or more
  VulkanRange vert{};         ///< per half-edge: the vertex it leaves
  VulkanRange twin{};         ///< per half-edge: the one the other way
};

/// What a VulkanTopology has room for.
struct VulkanTopologyOptions {
  MeshCounts most{};              ///< of the control mesh
  std::int32_t levels = 1;        ///< 1 or more
  std::int32_t maxValence = 255;  ///< of a control vertex; each factor of 16 costs a pass of a sort, of the vertices
  bool links = false;             ///< twins and faces of half-edges as well
};

/// The zip split on the device: from the half-edges of a closed control mesh, in buffers of the caller, those of every
/// level up to the last, equal array by array to what Far::zip makes of the same control mesh. For meshes whose
/// connectivity changes while the program runs: all that depends on the number of half-edges is recorded anew, nothing
/// is allocated and nothing read back. (Equal to Far::refine where the faces are sorted stably by their number of
/// sides, as Far::Topology::create sorts them; zip itself takes them in any order.)
///
/// Level k of a control mesh with H half-edges has 3^k H, laid out as Far::Topology lays them out:
///     vert(k)        per half-edge: the vertex it leaves. Its first zipCounts(control, k).vertices numbers are these
///                    vertices themselves, so that they are Far::Topology::outgoing() too
///     faceOffsets()  per face, and one more: its first half-edge. The same buffer for all levels, each of which is
///                    longer by the faces that it adds: level k's are the first zipCounts(control, k).faces + 1 numbers
///     parents(k)     per face: the face of the level before that it was made from, of the last
///                    zipCounts(control, k - 1).vertices of them the vertex
///     twin(k)        with links, per half-edge: the one the other way
///     face()         with links, per half-edge: its face. One buffer for all levels, as faceOffsets()
///
/// Faces made from the control mesh's vertices are sorted by valence (level 1), everything else follows from its number
/// alone: O(1) an entry, O(n) for a control vertex of valence n, O(log F) for a half-edge of level 1.
///
/// Memory: 4 bytes an entry of the arrays above, and about 36 a half-edge of the control mesh. A level's arrays
/// may pass maxStorageBufferRange; what is read at random places (vert of levels up to the last but one before the
/// last; with links, that of the last two) by 8 times.
///
/// Belongs to one thread at a time, and must outlive the execution of what was recorded with it; for frames in flight
/// make one for each. Copies of the evaluator it was made from share its pipelines.
class VulkanTopology {
 public:
  /// Binds the caller's buffers, which must hold as much as options.most says, at offsets that are multiples of the
  /// device's minStorageBufferOffsetAlignment and of 32. Compiles kernels where they are new.
  /// Errors: invalidOption (counts that no closed mesh has, levels, maxValence, a buffer that is missing, short or
  /// misaligned), tooLarge (past 2^31 - 1 half-edges, or past what the device binds at once: the message says which
  /// number to lower), outOfMemory, deviceLost.
  static Result<VulkanTopology> create(const VulkanEvaluator& evaluator, const VulkanControlMesh& mesh,
                                       const VulkanTopologyOptions& options);
  VulkanTopology(VulkanTopology&&) noexcept;
  VulkanTopology& operator=(VulkanTopology&&) noexcept;
  ~VulkanTopology();

  /// Records the refinement of a control mesh of that many vertices, faces and half-edges. Only records: never submits,
  /// allocates or updates. The command buffer must be in the recording state outside a render pass, of a family with
  /// compute, and loses its bound compute pipeline, descriptor set 0 and push constants.
  ///     waits for   COMPUTE_SHADER / SHADER_WRITE of all that comes before on the same queue, so that a control mesh
  ///                 from a kernel of the caller's, and the same object once more, need nothing in between
  ///     the caller  makes a control mesh that was copied visible to COMPUTE_SHADER / SHADER_READ (one that the host
  ///                 wrote before the submission is so), and lets COMPUTE_SHADER wait for those who still read
  ///     leaves      everything visible to COMPUTE_SHADER / SHADER_READ and SHADER_WRITE and, for check(), to HOST /
  ///                 HOST_READ; others take a barrier of the caller's
  /// Errors, with nothing recorded: tooLarge past options.most, invalidOption for counts that no closed mesh has.
  Result<void> record(VkCommandBuffer commands, const MeshCounts& control) const;

  /// Was the control mesh that was recorded last such a mesh as is wanted? To be asked when it has run; what is on the
  /// device otherwise is of no use, and has done no harm. O(1), without touching the device.
  /// Errors: invalidMesh, the message names the half-edge and what to do: a face with fewer than three sides, a vertex
  /// number out of range, a boundary, a twin that isn't one, a vertex of several fans of faces or none; tooLarge past
  /// options.maxValence; invalidOption before anything has run.
  Result<void> check() const;

  const VulkanTopologyOptions& options() const;
  /// Arrays of a level, 1 .. options().levels: buffers to be bound as storage, copied, or read as indices. Their sizes
  /// are of the largest mesh there is room for; nothing for another level.
  VulkanRange vert(std::int32_t level) const;
  /// A 32-bit number per face of the level: the face, or the vertex, of the level before that it was made from, as
  /// drawn above; levels as for vert().
  VulkanRange parents(std::int32_t level) const;
  /// Nothing without options().links.
  VulkanRange twin(std::int32_t level) const;
  VulkanRange face() const;
  /// Of all levels.
  VulkanRange faceOffsets() const;
  /// Bytes of device memory it takes.
  std::uint64_t byteCount() const;

 private:
  struct State;
  explicit VulkanTopology(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace honeycomb::Osd
