#include "apps/demo/creature_motion.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>

namespace honeycomb::Demo {
namespace {

using glm::dvec3;

constexpr double kTurn = 6.283185307179586;
constexpr double kStrides = 2.0;       // per loop
constexpr double kStanceShare = 0.62;  // of a stride that a foot is on the ground
constexpr double kStep = 0.27;         // half the way of a foot along x
constexpr double kLift = 0.13;
constexpr double kSpineYaw = 33.0 * kDegree;  // of each girdle, to either side
constexpr double kShoulderStation = kBodyRings[kFrontLegRing + 1].station;
constexpr double kHipStation = kBodyRings[kHindLegRing + 1].station;
constexpr double kMiddleStation = 0.5 * (kShoulderStation + kHipStation);

struct Key {
  double at, value;
};

/// Cubic through the keys with the slopes of their neighbours; constant outside.
double interpolate(std::span<const Key> keys, double at) {
  if (at <= keys.front().at) return keys.front().value;
  if (at >= keys.back().at) return keys.back().value;
  std::size_t i = 0;
  while (keys[i + 1].at < at) ++i;
  const auto slope = [&](std::size_t k) {
    const Key& a = keys[k == 0 ? 0 : k - 1];
    const Key& b = keys[std::min(k + 1, keys.size() - 1)];
    return (b.value - a.value) / (b.at - a.at);
  };
  const double width = keys[i + 1].at - keys[i].at;
  const double u = (at - keys[i].at) / width;
  const double v = 1.0 - u;
  return keys[i].value * v * v * (1.0 + 2.0 * u) + keys[i + 1].value * u * u * (1.0 + 2.0 * v) +
         width * u * v * (slope(i) * v - slope(i + 1) * u);
}

dvec3 rotated(const dvec3& vector, const dvec3& unitAxis, double angle) {
  return vector * std::cos(angle) + glm::cross(unitAxis, vector) * std::sin(angle) +
         unitAxis * (glm::dot(unitAxis, vector) * (1.0 - std::cos(angle)));
}

Frame turned(Frame frame, const dvec3& unitAxis, double angle) {
  frame.x = rotated(frame.x, unitAxis, angle);
  frame.y = rotated(frame.y, unitAxis, angle);
  frame.z = rotated(frame.z, unitAxis, angle);
  return frame;
}

/// Time as angles: of the stride, and of the whole loop.
struct Phase {
  double stride, loop;
};

/// Direction of the spine about the vertical, positive to the creature's left. The trunk bends as a standing wave whose
/// ends turn with the steps; the head holds against it; the tail carries it on as a travelling wave into a curl.
double yawAt(double station, Phase phase) {
  if (station <= kHipStation) {
    const double look = 14.0 * kDegree * std::sin(phase.loop);
    const double girdle = kSpineYaw * std::cos(phase.stride);
    const std::array keys = {Key{0.30, look - 0.10 * girdle}, Key{0.62, look - 0.18 * girdle},
                             Key{kShoulderStation, -girdle}, Key{kHipStation, girdle}};
    return interpolate(keys, station);
  }
  const double u = (station - kHipStation) / (kBodyLength - kHipStation);
  const double wave = kSpineYaw * (1.0 + 0.15 * u) * std::cos(phase.stride - 0.80 * kTurn * u);
  const double curl = (185.0 + 25.0 * std::sin(phase.loop)) * u * u * u - 110.0 * u * (1.0 - u);
  return wave + curl * kDegree;
}

/// Direction of the spine against the ground, positive with the snout up.
double pitchAt(double station, Phase phase) {
  const double nod = 4.0 * std::cos(2.0 * phase.stride);
  const double tip = 8.0 * std::sin(phase.stride);
  const std::array keys = {Key{0.20, 5.0 + nod}, Key{0.60, 7.0 + nod},   Key{0.95, 22.0},       Key{1.22, 13.0},
                           Key{1.70, 2.0},       Key{2.20, 6.0},         Key{2.60, 17.0},       Key{3.00, 13.0},
                           Key{3.40, 2.0},       Key{3.90, -14.0 + tip}, Key{4.50, -30.0 + tip}};
  return interpolate(keys, station) * kDegree;
}

double rollAt(double station, Phase phase) {
  const std::array keys = {Key{0.5, 0.0}, Key{kShoulderStation, 7.0}, Key{kHipStation, -7.0}, Key{3.2, 0.0}};
  return interpolate(keys, station) * kDegree * std::cos(phase.stride + 0.6);
}

Frame spineAxes(double station, Phase phase) {
  const double yaw = yawAt(station, phase);
  const double pitch = pitchAt(station, phase);
  Frame frame;
  frame.x = {std::cos(yaw) * std::cos(pitch), std::sin(pitch), -std::sin(yaw) * std::cos(pitch)};
  frame.z = {std::sin(yaw), 0.0, std::cos(yaw)};
  frame.y = glm::cross(frame.z, frame.x);
  return turned(frame, frame.x, rollAt(station, phase));
}

/// The way along the spine from one station to another: midpoint rule in steps of about 0.01.
dvec3 spineWay(double from, double to, Phase phase) {
  const int steps = static_cast<int>(std::ceil(std::abs(to - from) * 100.0)) + 1;
  const double step = (to - from) / steps;
  dvec3 way(0.0);
  for (int i = 0; i < steps; ++i) way -= step * spineAxes(from + (i + 0.5) * step, phase).x;
  return way;
}

/// Breath and the push of the steps: the trunk swells and flattens without changing its volume much.
void swell(Frame& frame, double station, Phase phase) {
  const std::array keys = {Key{0.9, 0.0}, Key{1.3, 0.6}, Key{1.7, 1.0}, Key{2.1, 0.6}, Key{2.6, 0.0}};
  const double breath = 0.045 * std::sin(2.0 * phase.stride + 0.8) * interpolate(keys, station);
  frame.y *= 1.0 - breath;
  frame.z *= 1.0 + breath;
}

void poseBody(std::vector<Frame>& pose, Phase phase) {
  const dvec3 toShoulder = spineWay(kMiddleStation, kShoulderStation, phase);
  const dvec3 toHip = spineWay(kMiddleStation, kHipStation, phase);
  dvec3 middle = -0.5 * (toShoulder + toHip);
  middle.y = 0.47 + 0.022 * std::cos(2.0 * phase.stride);
  for (int i = 0; i < kBodyRingCount; ++i) {
    const double station = kBodyRings[static_cast<std::size_t>(i)].station;
    Frame frame = spineAxes(station, phase);
    frame.origin = middle + spineWay(kMiddleStation, station, phase);
    swell(frame, station, phase);
    pose[static_cast<std::size_t>(i)] = frame;
  }
}

Frame mirrored(Frame frame) {
  for (dvec3* v : {&frame.origin, &frame.x, &frame.y, &frame.z}) v->z = -v->z;
  return frame;
}

/// The same body frame for a mirrored world: its z, which pointed right, points to the mirrored right again.
Frame mirroredBody(Frame frame) {
  frame = mirrored(frame);
  frame.z = -frame.z;
  return frame;
}

Frame bodyFrame(const std::vector<Frame>& pose, int ring, Side side) {
  const Frame& frame = pose[static_cast<std::size_t>(ring)];
  return side == Side::right ? frame : mirroredBody(frame);
}

void poseEyes(std::vector<Frame>& pose, Phase phase) {
  // One blink a loop, 0.16 of it long.
  const double shut = std::max(0.0, std::cos(phase.loop - 0.62 * kTurn) - 0.88) / 0.12;
  for (const Side side : kSides) {
    const Frame head = bodyFrame(pose, kEyeRing + 1, side);
    const dvec3 out = glm::normalize(dvec3(0.22, 0.60, 0.80));
    const dvec3 forward = glm::normalize(dvec3(1.0, 0.0, 0.0) - out * out.x);
    const auto axis = [&](const dvec3& v) { return head.x * v.x + head.y * v.y + head.z * v.z; };
    Frame eye{head.point({0.0, 0.148, 0.262}), axis(forward), axis(glm::cross(out, forward)), axis(out)};
    eye.y *= 1.0 - 0.35 * shut;
    eye.z *= 1.0 - 0.20 * shut;
    pose[static_cast<std::size_t>(eyeBone(side))] = side == Side::right ? eye : mirrored(eye);
  }
}

/// How a front or hind leg is made and where it steps, for the creature's right side.
struct LegPlan {
  int ring;
  dvec3 root;           ///< in the frame of the ring
  double upper, lower;  ///< lengths of the bones
  dvec3 bend;           ///< where the elbow or knee points
  dvec3 foot;           ///< middle of the palm's way
  double footAngle;     ///< of the foot on the ground, from forward to outwards
};

LegPlan legPlan(bool front) {
  if (front) {
    return {kFrontLegRing + 1,   {0.0, -0.03, 0.25},  0.43,          0.36,
            {-0.45, 0.80, 0.55}, {0.72, 0.085, 0.80}, 38.0 * kDegree};
  }
  return {kHindLegRing + 1, {0.0, -0.02, 0.21}, 0.46, 0.38, {0.45, 0.85, 0.55}, {-0.33, 0.085, 0.82}, 58.0 * kDegree};
}

/// A foot in its stride: where it is against the middle of its way, and how far through the air (0 on the ground).
struct Step {
  double along = 0.0, lift = 0.0;
  double tilt = 0.0;  ///< toes down as the foot leaves, up before it lands; radians
};

Step stepAt(double stridePart) {
  const double p = stridePart - std::floor(stridePart);
  if (p < kStanceShare) return {kStep * (1.0 - 2.0 * p / kStanceShare), 0.0, 0.0};
  const double u = (p - kStanceShare) / (1.0 - kStanceShare);
  const double v = 1.0 - u;
  // Leaves and lands with the speed of the ground.
  const double slope = -2.0 * kStep * (1.0 - kStanceShare) / kStanceShare;
  const double along = kStep * (u * u * (1.0 + 2.0 * v) - v * v * (1.0 + 2.0 * u)) + slope * u * v * (v - u);
  const double bell = 16.0 * u * u * v * v;
  return {along, kLift * bell, 24.0 * kDegree * bell * (v - u)};
}

Frame footFrame(const LegPlan& plan, const Step& step) {
  Frame foot;
  foot.origin = plan.foot + dvec3(step.along, step.lift, 0.35 * step.lift);
  foot.z = {std::cos(plan.footAngle), 0.0, std::sin(plan.footAngle)};
  foot.y = {0.0, 1.0, 0.0};
  foot.x = glm::cross(foot.y, foot.z);
  return turned(foot, foot.x, step.tilt);
}

/// A frame at `origin` along `along`, with x as near to `front` as that allows.
Frame limbFrame(const dvec3& origin, const dvec3& along, const dvec3& front) {
  Frame frame;
  frame.origin = origin;
  frame.z = glm::normalize(along);
  frame.x = glm::normalize(front - frame.z * glm::dot(front, frame.z));
  frame.y = glm::cross(frame.z, frame.x);
  return frame;
}

/// Where the elbow is, given both ends, by the law of cosines.
dvec3 elbowBetween(const LegPlan& plan, const dvec3& root, const dvec3& end, const dvec3& bend) {
  const double reach = std::min(glm::length(end - root), 0.985 * (plan.upper + plan.lower));
  const dvec3 along = glm::normalize(end - root);
  const double part = (reach * reach + plan.upper * plan.upper - plan.lower * plan.lower) / (2.0 * reach);
  const double height = std::sqrt(std::max(0.0, plan.upper * plan.upper - part * part));
  return root + along * part + glm::normalize(bend - along * glm::dot(bend, along)) * height;
}

void poseToes(std::span<Frame> bones, const Step& step) {
  constexpr std::array<double, kToeCount> kSplay = {82.0, 34.0, 0.0, -34.0, -82.0};
  const Frame& foot = bones[palm];
  for (int toe = 0; toe < kToeCount; ++toe) {
    const double splay = kSplay[static_cast<std::size_t>(toe)] * kDegree * (1.0 - 1.2 * step.lift);
    Frame frame = turned(foot, foot.y, splay);
    frame = turned(frame, frame.x, step.lift / kLift * 18.0 * kDegree);
    bones[firstToe + static_cast<std::size_t>(toe)] = frame;
  }
}

/// The frames of a leg of the right side, from its foot upwards.
void poseLeg(std::span<Frame> bones, const LegPlan& plan, const Frame& body, const Step& step) {
  const Frame foot = footFrame(plan, step);
  const dvec3 root = body.point(plan.root);
  const dvec3 ankle = foot.point({0.0, 0.055, -0.17});
  const dvec3 middle =
      elbowBetween(plan, root, ankle, body.x * plan.bend.x + body.y * plan.bend.y + body.z * plan.bend.z);
  const dvec3 upper = glm::normalize(middle - root);
  const dvec3 lower = glm::normalize(ankle - middle);
  const dvec3 front = glm::normalize(glm::cross(upper, lower));
  bones[shoulder] = limbFrame(root + 0.15 * body.z + 0.04 * upper, upper + 1.5 * body.z, front + 1.5 * body.x);
  bones[upperLimb] = limbFrame(glm::mix(root, middle, 0.66) + 0.02 * body.z, upper + 0.2 * body.z, front);
  bones[elbow] = limbFrame(glm::mix(middle, 0.5 * (root + ankle), 0.06), upper + lower, front);
  bones[lowerLimb] = limbFrame(glm::mix(middle, ankle, 0.52), lower, front + 0.4 * foot.x);
  bones[wrist] = limbFrame(ankle, lower + 1.2 * foot.z, front + 1.5 * foot.x);
  bones[palm] = foot;
  poseToes(bones, step);
}

void poseLegs(std::vector<Frame>& pose, Phase phase) {
  for (std::size_t leg = 0; leg < kLegs.size(); ++leg) {
    // Diagonal pairs step together: the left front and right hind feet land at the start of a stride.
    const bool firstPair = (kLegs[leg].side == Side::left) == kLegs[leg].front;
    const Step step = stepAt(phase.stride / kTurn + (firstPair ? 0.0 : 0.5));
    const LegPlan plan = legPlan(kLegs[leg].front);
    const std::span<Frame> bones =
        std::span(pose).subspan(static_cast<std::size_t>(legBone(static_cast<int>(leg), 0)), kLegBoneCount);
    poseLeg(bones, plan, bodyFrame(pose, plan.ring, kLegs[leg].side), step);
    if (kLegs[leg].side == Side::right) continue;
    for (Frame& frame : bones) frame = mirrored(frame);
  }
}

}  // namespace

std::vector<Frame> poseAt(double time) {
  const Phase phase{kTurn * kStrides * time, kTurn * time};
  std::vector<Frame> pose(static_cast<std::size_t>(kBoneCount));
  poseBody(pose, phase);
  poseEyes(pose, phase);
  poseLegs(pose, phase);
  return pose;
}

}  // namespace honeycomb::Demo
