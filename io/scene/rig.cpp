#include "io/scene/rig.h"

#include <algorithm>

#include "far/base/index.h"

namespace honeycomb::Io {
namespace {

// Nearer to each other than this cosine, the arc is a line in double precision.
constexpr double kNearlyEqual = 1 - 1e-12;

template <std::size_t N>
std::array<double, N> keyValue(const Keys& keys, std::size_t key) {
  std::array<double, N> value;
  std::copy_n(keys.values.begin() + static_cast<std::ptrdiff_t>(N * key), N, value.begin());
  return value;
}

template <std::size_t N>
std::array<double, N> mixed(const std::array<double, N>& a, double ofA, const std::array<double, N>& b, double ofB) {
  std::array<double, N> value;
  for (std::size_t i = 0; i < N; ++i) value[i] = ofA * a[i] + ofB * b[i];
  return value;
}

Vector3 vectorAt(const Keys& keys, double seconds) {
  const KeyPlace place = findKey(keys.times, seconds);
  return mixed(keyValue<3>(keys, place.before), 1 - place.share, keyValue<3>(keys, place.after), place.share);
}

// Shoemake, Animating Rotation with Quaternion Curves, SIGGRAPH 1985.
Quaternion rotationAt(const Keys& keys, double seconds) {
  const KeyPlace place = findKey(keys.times, seconds);
  const Quaternion a = keyValue<4>(keys, place.before);
  Quaternion b = keyValue<4>(keys, place.after);
  double cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  if (cosine < 0) {
    for (double& x : b) x = -x;
    cosine = -cosine;
  }
  if (cosine > kNearlyEqual) return place.share < 0.5 ? a : b;
  const double angle = std::acos(cosine);
  const double sine = std::sin(angle);
  return mixed(a, std::sin((1 - place.share) * angle) / sine, b, std::sin(place.share * angle) / sine);
}

Transform localAt(const RigNode& node, const NodeTrack& track, double seconds) {
  Placement placement = node.placement;
  if (!track.translations.empty()) placement.translation = vectorAt(track.translations, seconds);
  if (!track.rotations.empty()) placement.rotation = rotationAt(track.rotations, seconds);
  if (!track.scales.empty()) placement.scale = vectorAt(track.scales, seconds);
  return placement.transform();
}

}  // namespace

KeyPlace findKey(const std::vector<double>& times, double seconds) {
  const auto next = std::upper_bound(times.begin(), times.end(), seconds);
  if (next == times.begin()) return {};
  const auto after = static_cast<std::size_t>(next - times.begin());
  if (next == times.end()) return {after - 1, after - 1, 0};
  return {after - 1, after, (seconds - times[after - 1]) / (times[after] - times[after - 1])};
}

std::vector<Transform> placeNodes(const std::vector<RigNode>& nodes, const Clip* clip, double seconds) {
  std::vector<Transform> placed(nodes.size());
  for (std::size_t n = 0; n < nodes.size(); ++n) placed[n] = nodes[n].local;
  if (clip) {
    for (const NodeTrack& track : clip->tracks) placed[at(track.node)] = localAt(nodes[at(track.node)], track, seconds);
  }
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (nodes[n].parent >= 0) placed[n] = placed[at(nodes[n].parent)] * placed[n];
  }
  return placed;
}

}  // namespace honeycomb::Io
