#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "io/scene/rig.h"

namespace honeycomb::Io {

/// What moves a vertex: a node, from the space the vertex is given in. A mesh that hangs on a node has one of these.
struct Joint {
  std::int32_t node = 0;
  Transform offset;  ///< from the mesh's space to the node's as it was when the mesh was bound to it

  bool operator==(const Joint&) const = default;
};

struct Influence {
  std::int32_t joint = 0;
  double weight = 0;

  bool operator==(const Influence&) const = default;
};

/// A shape that is mixed in by a weight, which animations may move.
struct MorphTarget {
  std::int32_t node = 0;   ///< whose weights are meant
  std::int32_t index = 0;  ///< which of them
  double weight = 0;       ///< where nothing moves it

  bool operator==(const MorphTarget&) const = default;
};

/// What a target at weight 1 adds to a vertex.
struct MorphOffset {
  std::int32_t target = 0;
  Vector3 offset{};

  bool operator==(const MorphOffset&) const = default;
};

/// Vertices and what moves them:
///     p(t) = sum_i weight_i J_i(t) (p + sum_m w_m(t) offset_m),  J_i(t) = node's transform at t x the joint's offset
/// Vertex v has the influences influences[influenceOffsets[v]] .. [influenceOffsets[v+1]-1], by rising joint, whose
/// weights sum to 1; its morph offsets lie the same way, by rising target.
struct Skin {
  std::vector<Joint> joints;
  std::vector<MorphTarget> targets;
  std::vector<double> positions;  ///< x y z per vertex
  std::vector<std::int64_t> influenceOffsets{0};
  std::vector<Influence> influences;
  std::vector<std::int64_t> morphOffsets{0};
  std::vector<MorphOffset> morphs;

  std::int64_t vertexCount() const { return static_cast<std::int64_t>(positions.size() / 3); }
  Vector3 position(std::int64_t v) const;
  std::span<const Influence> influencesOf(std::int64_t v) const;
  std::span<const MorphOffset> morphsOf(std::int64_t v) const;
  /// Appends vertex v of `other`, whose joints and targets are the same.
  void append(const Skin& other, std::int64_t v);
};

/// Where the vertices are: x y z each, as a clip has them at a moment, or (null) as the nodes stand. In double, order
/// of operations as above from left to right. Linear in influences and offsets, in parallel.
std::vector<double> poseSkin(const Skin& skin, const std::vector<RigNode>& nodes, const Clip* clip, double seconds);

}  // namespace honeycomb::Io
