#pragma once

#include <cstdint>
#include <vector>

#include "far/base/result.h"
#include "far/topology/polygons.h"

namespace honeycomb::Far {

/// The control mesh that a step of half-box subdivision maps to itself, halved: what every mesh looks like in the end
/// round a face of n sides. P. Barendrecht, M. Sabin, J. Kosinka, "A bivariate C1 subdivision scheme based on cubic
/// half-box splines", CAGD 2019, section 4.1: the two eigenvectors of the subdominant eigenvalue 1/2, as x and y. Its
/// limit surface is the characteristic map.
///
/// Face 0 is the n-gon, face 1+k the hexagon across its edge from corner k to corner k+1. All lie in the plane, the
/// n-gon counter-clockwise round the origin; corner k is at angle 2 pi k/n, at distance 1. For n = 3 and 4 some
/// vertices coincide with the original S2.
///     vertex  k        corner of the n-gon           2n + k   neighbour of n + k in the hexagon before corner k
///             n + k    its neighbour outside         3n + k   neighbour of n + k in the hexagon behind corner k
struct NaturalConfiguration {
  std::int32_t sides = 0;
  Polygons polygons;
  std::vector<double> points;  ///< x y 0 of the 4n vertices
};

/// The eigenvalue of a natural configuration: a step leads to the same mesh, this many times as large.
constexpr double kHalfBoxContraction = 0.5;

constexpr std::int32_t kMostConfigurationSides = 100'000;

/// `tunedWeight`: b_n of the second stencil S2 beside the n-gon (HalfBoxOptions::tunedWeights), in [1/6, 1/2]; 1/4 is
/// the original S2. Linear in the sides. Errors: invalidOption unless 3 <= sides <= kMostConfigurationSides, or for a
/// weight out of range.
Result<NaturalConfiguration> naturalConfiguration(std::int32_t sides, double tunedWeight = 0.25);

}  // namespace honeycomb::Far
