#pragma once

#include <cstdint>
#include <vector>

#include "far/base/result.h"
#include "far/schemes/half_box_clamped.h"
#include "far/schemes/scheme.h"

namespace honeycomb::Far {

/// Which steps take the weights that keep the control points of small faces apart.
enum class HalfBoxTuning : std::uint8_t {
  none,
  first,  ///< only the first step, the one where extraordinary faces meet; the limit surface stays piecewise polynomial
  all     ///< every step; limits of vertices beside extraordinary faces are then those of one tuned step more, untuned
          ///< after
};

/// How a mesh that is not three-valent is made so, by a step of its own before the first.
enum class HalfBoxConversion : std::uint8_t {
  automatic,  ///< none where the mesh is three-valent, the dual where all faces are triangles, else an Akleman step
  none,
  dual,     ///< the dual: a vertex at the centroid of each face
  trisect,  ///< corners cut off at a third of the edges
  akleman   ///< a step of honeycomb subdivision; borders by its brick rule
};

/// Where the surface of an open mesh ends.
enum class HalfBoxBoundary : std::uint8_t {
  natural,  ///< with the patches of the vertices inside, by the rules of the inside
  clamped   ///< at the same curve (but for corners), whose control points are points of the refined meshes: a step of
            ///< its own, clampStep(), makes them
};

/// What halfBox() is free to choose.
struct HalfBoxOptions {
  HalfBoxTuning tuning = HalfBoxTuning::none;
  /// b_n: the weight of a vertex on itself beside one extraordinary face of n sides and two hexagons, in [1/6, 1/2];
  /// side counts that are not named have 1/4. The paper's.
  TunedWeights tunedWeights = {{3, 0.45}, {4, 0.35}};
  HalfBoxConversion conversion = HalfBoxConversion::automatic;
  HalfBoxBoundary boundary = HalfBoxBoundary::natural;
  HalfBoxCorners corners = HalfBoxCorners::convex;  ///< of a clamped boundary
};

/// b_n = -(3/4) cos(4 pi/n)/(1 - cos(4 pi/n)), for n = 4 .. 8: the weight that removes the Jordan block at the
/// eigenvalue 1/4 and with it the unbounded curvature at faces of n sides.
double boundedCurvatureWeight(std::int32_t sides);

/// One step of P. Barendrecht, M. Sabin, J. Kosinka, "A bivariate C1 subdivision scheme based on cubic half-box
/// splines", CAGD 2019, on the chamfer split of a three-valent mesh:
///     S1, corner k of a hexagon      (1/2, 1/8, 1/8, 0, 1/8, 1/8)                     (Fig 5)
///         of an n-gon                alpha_0 = 1/4 + 5/(4n), alpha_i = (3 + 2 cos(2 pi i/n))/(4n)      (eq 7)
///     S2(v) = (v + w_1 + w_2 + w_3)/4
/// `tuned`: every face of n sides at v adds b_n - 1/4 to the weight of v and takes half of it from each of v's two
/// neighbours in the face; for one extraordinary face these are the paper's weights.
/// On a clamped boundary: clampedHalfBoxStep().
/// Errors: invalidOption for a weight out of range.
Result<Scheme> halfBoxStep(const HalfBoxOptions& options, bool tuned);

/// The chain that refines `control` by `levels` half-box steps: a conversion first where one is needed, so that the
/// three-valent mesh is level 1 and there is one level more, then the steps. The natural boundary is the paper's: the
/// surface ends with the patches of the vertices inside. A clamped boundary takes one level more, between conversion
/// and steps, where there are steps and the mesh is open; corners are its faces that turn (clampStep()), and corner
/// tags say nothing beyond what they do to the boundary in an Akleman conversion. Errors: invalidMesh naming a vertex
/// that has not three edges when there is to be no conversion, or a face that the dual can't be made of; invalidOption.
Result<std::vector<Scheme>> halfBox(const Topology& control, std::int32_t levels, const HalfBoxOptions& options = {});

}  // namespace honeycomb::Far
