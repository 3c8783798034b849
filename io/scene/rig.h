#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/scene/transform.h"

namespace honeycomb::Io {

/// What is between two keys.
enum class Interpolation {
  linear,  ///< of rotations: the great arc
  step,    ///< the former of the two
  cubic    ///< Hermite's, by tangents of each key
};

/// Values at moments: `width` numbers a key.
struct Keys {
  std::vector<double> times;   ///< seconds, ascending
  std::vector<double> values;  ///< width x times; cubic: of each key the tangent before it, the value, the one behind
  Interpolation interpolation = Interpolation::linear;

  bool empty() const { return times.empty(); }
};

/// Where a moment falls among keys: between `before` and `after`, `share` of the way. Before the first and after the
/// last key time stands still. `keys` aren't empty. Logarithmic.
struct KeyPlace {
  std::size_t before = 0;
  std::size_t after = 0;
  double share = 0;
};
KeyPlace findKey(const std::vector<double>& times, double seconds);

/// Number i of the `width` that keys have at a place among them, each number for itself.
double numberAt(const Keys& keys, std::size_t width, std::size_t i, const KeyPlace& place);

/// How a clip moves one node; what has no keys stays as the node has it.
struct NodeTrack {
  std::int32_t node = 0;
  Keys translations;  ///< 3
  Keys rotations;     ///< 4: w x y z of length 1
  Keys scales;        ///< 3
};

/// The weights of the morph targets of a node's meshes.
struct MorphTrack {
  std::int32_t node = 0;
  std::int32_t targets = 0;
  Keys weights;  ///< `targets`
};

struct Clip {
  std::string name;
  double seconds = 0;
  double framesPerSecond = 0;  ///< as it was made; 0: the file doesn't say
  std::int64_t keys = 0;       ///< of its tracks together
  std::vector<NodeTrack> tracks;
  std::vector<MorphTrack> morphs;
};

struct RigNode {
  std::string name;
  std::int32_t parent = -1;  ///< lower than the node's own number; -1: none
  Transform local;           ///< to the parent's space, where nothing moves it
  Placement placement;       ///< the same in parts, as far as it has such
};

/// Each node's map to the space of the scene: as a clip has it at a moment, or (null) as the nodes stand. Linear
/// in nodes.
std::vector<Transform> placeNodes(const std::vector<RigNode>& nodes, const Clip* clip, double seconds);

}  // namespace honeycomb::Io
