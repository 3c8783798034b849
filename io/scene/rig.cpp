#include "io/scene/rig.h"

#include <algorithm>

#include "far/base/index.h"

namespace honeycomb::Io {
namespace {

// Nearer to each other than this cosine, the arc is a line in double precision.
constexpr double kNearlyEqual = 1 - 1e-12;

/// Where number i of key `key` lies.
std::size_t placeOf(const Keys& keys, std::size_t width, std::size_t key, std::size_t i) {
  return keys.interpolation == Interpolation::cubic ? width * (3 * key + 1) + i : width * key + i;
}

/// glTF 2.0, appendix C.5: Hermite's polynomials, tangents in values a second.
double cubicAt(const Keys& keys, std::size_t width, std::size_t i, const KeyPlace& place) {
  const double t = place.share, seconds = keys.times[place.after] - keys.times[place.before];
  const std::size_t a = placeOf(keys, width, place.before, i), b = placeOf(keys, width, place.after, i);
  const double t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * keys.values[a] + seconds * (t3 - 2 * t2 + t) * keys.values[a + width] +
         (3 * t2 - 2 * t3) * keys.values[b] + seconds * (t3 - t2) * keys.values[b - width];
}

template <std::size_t N>
std::array<double, N> numbersAt(const Keys& keys, const KeyPlace& place) {
  std::array<double, N> value;
  for (std::size_t i = 0; i < N; ++i) value[i] = numberAt(keys, N, i, place);
  return value;
}

Vector3 vectorAt(const Keys& keys, double seconds) {
  return numbersAt<3>(keys, findKey(keys.times, seconds));
}

// Shoemake, Animating Rotation with Quaternion Curves, SIGGRAPH 1985.
Quaternion onGreatArc(const Quaternion& a, Quaternion b, double share) {
  double cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  if (cosine < 0) {
    for (double& x : b) x = -x;
    cosine = -cosine;
  }
  if (cosine > kNearlyEqual) return share < 0.5 ? a : b;
  const double angle = std::acos(cosine);
  const double sine = std::sin(angle), ofA = std::sin((1 - share) * angle) / sine, ofB = std::sin(share * angle) / sine;
  return {ofA * a[0] + ofB * b[0], ofA * a[1] + ofB * b[1], ofA * a[2] + ofB * b[2], ofA * a[3] + ofB * b[3]};
}

Quaternion rotationAt(const Keys& keys, double seconds) {
  const KeyPlace place = findKey(keys.times, seconds);
  if (keys.interpolation == Interpolation::linear)
    return onGreatArc(numbersAt<4>(keys, {place.before, place.before, 0}),
                      numbersAt<4>(keys, {place.after, place.after, 0}), place.share);
  Quaternion value = numbersAt<4>(keys, place);
  const double length =
      std::sqrt(value[0] * value[0] + value[1] * value[1] + value[2] * value[2] + value[3] * value[3]);
  // Tangents may lead through no rotation at all.
  if (!(length > 0)) return numbersAt<4>(keys, {place.before, place.before, 0});
  for (double& x : value) x /= length;
  return value;
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

double numberAt(const Keys& keys, std::size_t width, std::size_t i, const KeyPlace& place) {
  const double former = keys.values[placeOf(keys, width, place.before, i)];
  if (keys.interpolation == Interpolation::step || place.before == place.after) return former;
  if (keys.interpolation == Interpolation::cubic) return cubicAt(keys, width, i, place);
  return (1 - place.share) * former + place.share * keys.values[placeOf(keys, width, place.after, i)];
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
