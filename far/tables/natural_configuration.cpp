#include "far/tables/natural_configuration.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "far/base/index.h"

namespace honeycomb::Far {
namespace {

using Complex = std::complex<double>;

/// The four vertices of sector 0, x + iy: the eigenvector of the paper's block D_1 for the eigenvalue 1/2. The block is
/// lower triangular, so its rows give the entries one after the other.
std::array<Complex, 4> eigenvector(std::int32_t sides, double b) {
  const double angle = 2 * std::numbers::pi / sides;
  const Complex omega = std::polar(1.0, angle);
  const double c = (0.75 - b) / 2;
  const double corner = 1;
  const double outside = (b + 2 * c * std::cos(angle)) * corner / (kHalfBoxContraction - 0.25);
  const auto beside = [&](Complex turn) {
    return ((0.5 + turn / 8.0) * corner + (1.0 + turn) / 8.0 * outside) / (kHalfBoxContraction - 0.125);
  };
  return {corner, outside, beside(std::conj(omega)), beside(omega)};
}

Polygons configurationPolygons(std::int32_t n) {
  Polygons polygons;
  polygons.vertexCount = 4 * n;
  std::vector<std::int32_t> middle(at(n));
  for (std::int32_t k = 0; k < n; ++k) middle[at(k)] = k;
  polygons.addFace(middle);
  for (std::int32_t k = 0; k < n; ++k) {
    const std::int32_t next = (k + 1) % n;
    polygons.addFace({next, k, n + k, 3 * n + k, 2 * n + next, n + next});
  }
  return polygons;
}

}  // namespace

Result<NaturalConfiguration> naturalConfiguration(std::int32_t sides, double tunedWeight) {
  if (sides < 3 || sides > kMostConfigurationSides) {
    return fail(ErrorCode::invalidOption, fmt::format("a face of {} sides has no natural configuration; give 3 to {}",
                                                      sides, kMostConfigurationSides));
  }
  if (!(tunedWeight >= 1.0 / 6 && tunedWeight <= 0.5)) {
    return fail(
        ErrorCode::invalidOption,
        fmt::format("the weight {} beside a face of {} sides is out of range; give 1/6 to 1/2", tunedWeight, sides));
  }
  NaturalConfiguration made{sides, configurationPolygons(sides), std::vector<double>(at(12 * sides))};
  const std::array<Complex, 4> sector = eigenvector(sides, tunedWeight);
  for (std::int32_t k = 0; k < sides; ++k) {
    const Complex turn = std::polar(1.0, 2 * std::numbers::pi * k / sides);
    for (std::int32_t i = 0; i < 4; ++i) {
      const Complex point = turn * sector[at(i)];
      made.points[at(3 * (i * sides + k))] = point.real();
      made.points[at(3 * (i * sides + k) + 1)] = point.imag();
    }
  }
  return made;
}

}  // namespace honeycomb::Far
