#include "io/scene/skin.h"

#include "far/base/index.h"
#include "far/base/parallel.h"

namespace honeycomb::Io {
namespace {

template <class T>
std::span<const T> rowOf(const std::vector<std::int64_t>& offsets, const std::vector<T>& values, std::int64_t v) {
  return std::span<const T>(values).subspan(at(offsets[at(v)]), at(offsets[at(v) + 1] - offsets[at(v)]));
}

template <class T>
void appendRow(std::vector<std::int64_t>& offsets, std::vector<T>& values, std::span<const T> row) {
  values.insert(values.end(), row.begin(), row.end());
  offsets.push_back(static_cast<std::int64_t>(values.size()));
}

std::vector<Transform> poseJoints(const Skin& skin, const std::vector<Transform>& nodes) {
  std::vector<Transform> joints;
  for (const Joint& joint : skin.joints) joints.push_back(nodes[at(joint.node)] * joint.offset);
  return joints;
}

std::vector<double> morphWeights(const Skin& skin, const Clip* clip, double seconds) {
  std::vector<double> weights;
  for (const MorphTarget& target : skin.targets) {
    weights.push_back(target.weight);
    if (!clip) continue;
    for (const MorphTrack& track : clip->morphs) {
      if (track.node != target.node || target.index >= track.targets || track.weights.empty()) continue;
      weights.back() =
          numberAt(track.weights, at(track.targets), at(target.index), findKey(track.weights.times, seconds));
    }
  }
  return weights;
}

}  // namespace

Vector3 Skin::position(std::int64_t v) const {
  return {positions[3 * at(v)], positions[3 * at(v) + 1], positions[3 * at(v) + 2]};
}

std::span<const Influence> Skin::influencesOf(std::int64_t v) const {
  return rowOf(influenceOffsets, influences, v);
}

std::span<const MorphOffset> Skin::morphsOf(std::int64_t v) const {
  return rowOf(morphOffsets, morphs, v);
}

void Skin::append(const Skin& other, std::int64_t v) {
  const Vector3 point = other.position(v);
  positions.insert(positions.end(), point.begin(), point.end());
  appendRow(influenceOffsets, influences, other.influencesOf(v));
  appendRow(morphOffsets, morphs, other.morphsOf(v));
}

std::vector<double> poseSkin(const Skin& skin, const std::vector<RigNode>& nodes, const Clip* clip, double seconds) {
  const std::vector<Transform> joints = poseJoints(skin, placeNodes(nodes, clip, seconds));
  const std::vector<double> weights = morphWeights(skin, clip, seconds);
  std::vector<double> points(skin.positions.size());
  Parallel::forEach(
      0, skin.vertexCount(),
      [&](std::int64_t v) {
        Vector3 point = skin.position(v);
        for (const MorphOffset& morph : skin.morphsOf(v))
          for (std::size_t i = 0; i < 3; ++i) point[i] += weights[at(morph.target)] * morph.offset[i];
        for (const Influence& influence : skin.influencesOf(v)) {
          const Vector3 moved = joints[at(influence.joint)].apply(point);
          for (std::size_t i = 0; i < 3; ++i) points[3 * at(v) + i] += influence.weight * moved[i];
        }
      },
      1024);
  return points;
}

}  // namespace honeycomb::Io
