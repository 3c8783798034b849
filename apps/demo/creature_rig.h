#pragma once

#include <array>
#include <glm/vec3.hpp>

namespace honeycomb::Demo {

/// In radians.
inline constexpr double kDegree = 0.017453292519943295;

/// A place and three axes that vertices are bound to. The axes carry scale, and on the creature's left side they are
/// mirrored, so that both sides are bound with the same local coordinates.
///     body rings   x forward, y up, z to the creature's right
///     limbs        x to the front of the limb, y its upper or outer side, z along it towards the toes
///     eyes         x forward, y up, z outwards
struct Frame {
  glm::dvec3 origin{0.0};
  glm::dvec3 x{1.0, 0.0, 0.0}, y{0.0, 1.0, 0.0}, z{0.0, 0.0, 1.0};

  glm::dvec3 point(const glm::dvec3& local) const { return origin + x * local.x + y * local.y + z * local.z; }
};

/// A cross section of the body at rest: an ellipse with an upper and a lower half of their own height.
struct BodyRing {
  double station;  ///< arc length from the snout, towards the tail
  double halfWidth, top, bottom;
  int sides;  ///< vertices of the ring: 16 on the head, 12 on the trunk, 8 and 6 on the tail
};

inline constexpr std::array kBodyRings = {
    // head
    BodyRing{0.05, 0.170, 0.085, 0.085, 16}, BodyRing{0.15, 0.255, 0.135, 0.115, 16},
    BodyRing{0.28, 0.315, 0.180, 0.145, 16}, BodyRing{0.43, 0.365, 0.225, 0.170, 16},
    BodyRing{0.58, 0.400, 0.250, 0.190, 16}, BodyRing{0.73, 0.400, 0.255, 0.200, 16},
    BodyRing{0.87, 0.345, 0.240, 0.200, 16},
    // neck, shoulders, trunk, hips
    BodyRing{0.99, 0.285, 0.225, 0.205, 12}, BodyRing{1.10, 0.290, 0.235, 0.220, 12},
    BodyRing{1.22, 0.320, 0.250, 0.235, 12}, BodyRing{1.37, 0.335, 0.265, 0.245, 12},
    BodyRing{1.54, 0.355, 0.280, 0.260, 12}, BodyRing{1.71, 0.365, 0.285, 0.265, 12},
    BodyRing{1.88, 0.350, 0.275, 0.255, 12}, BodyRing{2.05, 0.320, 0.260, 0.235, 12},
    BodyRing{2.20, 0.295, 0.245, 0.215, 12}, BodyRing{2.35, 0.265, 0.225, 0.195, 12},
    BodyRing{2.50, 0.230, 0.205, 0.175, 12},
    // tail
    BodyRing{2.66, 0.215, 0.190, 0.165, 8}, BodyRing{2.85, 0.210, 0.180, 0.160, 8},
    BodyRing{3.04, 0.200, 0.170, 0.155, 8}, BodyRing{3.24, 0.185, 0.160, 0.145, 8},
    BodyRing{3.43, 0.168, 0.147, 0.135, 8}, BodyRing{3.61, 0.150, 0.133, 0.125, 8},
    BodyRing{3.79, 0.135, 0.122, 0.115, 6}, BodyRing{3.96, 0.120, 0.110, 0.105, 6},
    BodyRing{4.13, 0.104, 0.098, 0.093, 6}, BodyRing{4.29, 0.090, 0.085, 0.080, 6},
    BodyRing{4.43, 0.076, 0.072, 0.068, 6}, BodyRing{4.57, 0.062, 0.058, 0.055, 6},
    BodyRing{4.69, 0.045, 0.042, 0.040, 6}};

inline constexpr int kBodyRingCount = static_cast<int>(kBodyRings.size());
inline constexpr double kBodyLength = 4.80;

/// The rings that the eyes and legs grow between: each opening spans two rows of faces from this ring on.
inline constexpr int kEyeRing = 3;
inline constexpr int kFrontLegRing = 8;
inline constexpr int kHindLegRing = 14;

enum class Side { right, left };
inline constexpr std::array kSides = {Side::right, Side::left};

struct Leg {
  Side side;
  bool front;
};
inline constexpr std::array kLegs = {Leg{Side::right, true}, Leg{Side::left, true}, Leg{Side::right, false},
                                     Leg{Side::left, false}};

/// The frames of a limb from the body outwards; toes are counted from the front of the foot to its back.
enum LegBone { shoulder, upperLimb, elbow, lowerLimb, wrist, palm, firstToe };
inline constexpr int kToeCount = 5;
inline constexpr int kLegBoneCount = firstToe + kToeCount;

// All frames of a pose in one array: body rings | right eye, left eye | legs in the order of kLegs.
constexpr int eyeBone(Side side) {
  return kBodyRingCount + static_cast<int>(side);
}
constexpr int legBone(int leg, int bone) {
  return kBodyRingCount + 2 + leg * kLegBoneCount + bone;
}
inline constexpr int kBoneCount = legBone(static_cast<int>(kLegs.size()), 0);

}  // namespace honeycomb::Demo
