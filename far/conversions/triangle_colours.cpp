#include "far/conversions/triangle_colours.h"

#include <algorithm>

#include "far/base/index.h"

namespace honeycomb::Far {
namespace {

/// Colours of the corners of one component's triangles, and which colours turned out to be the same.
class Colouring {
 public:
  explicit Colouring(const Topology& topology) : topology_(topology), colour_(at(topology.halfEdgeCount()), kNone) {}

  bool reached(std::int32_t f) const { return colour_[at(topology_.faceOffsets()[at(f)])] != kNone; }

  /// Colours the component of face f; its vertices, ascending, each with its class of colours.
  std::vector<std::pair<std::int32_t, std::int8_t>> colourComponent(std::int32_t f) {
    same_ = {0, 1, 2};
    queue_.assign(1, f);
    for (std::int32_t k = 0; k < 3; ++k) colour_[at(topology_.faceOffsets()[at(f)] + k)] = static_cast<std::int8_t>(k);
    for (std::size_t i = 0; i < queue_.size(); ++i) carryOver(queue_[i]);
    return vertices();
  }

  int classCount() const { return (same_[0] == 0) + (same_[1] == 1) + (same_[2] == 2); }

  /// Where two colours are one class: 1 for these and -2 for the third.
  std::array<std::int8_t, 3> valuesOfTwoClasses() const {
    std::array<std::int8_t, 3> values{};
    for (std::size_t c = 0; c < 3; ++c) {
      const auto members = std::count(same_.begin(), same_.end(), static_cast<std::int8_t>(c));
      values[c] = static_cast<std::int8_t>(members == 1 ? -2 : 1);
    }
    return values;
  }

 private:
  static constexpr std::int8_t kNone = -1;

  void carryOver(std::int32_t f) {
    for (std::int32_t k = 0; k < 3; ++k) {
      const std::int32_t h = topology_.faceOffsets()[at(f)] + k;
      const std::int32_t t = topology_.twin(h);
      const std::array<std::int32_t, 3> here{h, topology_.next(h), topology_.prev(h)};
      const std::array<std::int32_t, 3> there{topology_.next(t), t, topology_.prev(t)};
      if (!reached(topology_.face(t))) queue_.push_back(topology_.face(t));
      for (std::size_t c = 0; c < 3; ++c) match(colour_[at(here[c])], colour_[at(there[c])]);
    }
  }

  void match(std::int8_t carried, std::int8_t& found) {
    if (found == kNone) found = carried;
    const std::int8_t a = same_[at(carried)], b = same_[at(found)];
    for (std::int8_t& c : same_)
      if (c == std::max(a, b)) c = std::min(a, b);
  }

  std::vector<std::pair<std::int32_t, std::int8_t>> vertices() const {
    std::vector<std::pair<std::int32_t, std::int8_t>> result;
    for (const std::int32_t f : queue_)
      for (const std::int32_t h : topology_.halfEdgesOf(f))
        if (topology_.outgoing(topology_.vert(h)) == h)
          result.emplace_back(topology_.vert(h), same_[at(colour_[at(h)])]);
    std::sort(result.begin(), result.end());
    return result;
  }

  const Topology& topology_;
  std::vector<std::int8_t> colour_;
  std::array<std::int8_t, 3> same_{};
  std::vector<std::int32_t> queue_;
};

NullFunction functionOf(const std::vector<std::pair<std::int32_t, std::int8_t>>& coloured,
                        const std::array<std::int8_t, 3>& valueOfClass, std::int8_t pivotClass) {
  NullFunction function;
  function.pivot = -1;
  for (const auto& entry : coloured) {
    function.vertices.push_back(entry.first);
    function.values.push_back(valueOfClass[at(entry.second)]);
    if (function.pivot < 0 && entry.second == pivotClass) function.pivot = entry.first;
  }
  return function;
}

}  // namespace

std::vector<NullFunction> nullFunctions(const Topology& triangles) {
  std::vector<NullFunction> basis;
  Colouring colouring(triangles);
  for (std::int32_t f = 0; f < triangles.faceCount(); ++f) {
    if (colouring.reached(f)) continue;
    const auto coloured = colouring.colourComponent(f);
    if (colouring.classCount() == 3) {
      basis.push_back(functionOf(coloured, {1, 0, -1}, 0));
      basis.push_back(functionOf(coloured, {0, 1, -1}, 1));
    } else if (colouring.classCount() == 2) {
      basis.push_back(functionOf(coloured, colouring.valuesOfTwoClasses(), 0));
    }
  }
  return basis;
}

}  // namespace honeycomb::Far
