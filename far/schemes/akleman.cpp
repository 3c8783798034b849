#include "far/schemes/akleman.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "far/schemes/zip_boundary.h"

namespace honeycomb::Far {

namespace {

/// The a(N) for which |lambda_1| = (a + (N-5)(1-a)/(3N-5)) cos(pi/N) is 1/sqrt 3.
double sqrt3Tension(double n) {
  const double r = 1 / (std::numbers::sqrt3 * std::cos(std::numbers::pi / n));
  return std::min(1.0, ((3 * n - 5) * r - (n - 5)) / (2 * n));
}

CirculantRule aklemanRule(double a, double t, std::int32_t sides) {
  const double q = (1 - a) / (3 * sides - 5);
  const double angle = 2 * std::numbers::pi / sides;
  CirculantRule rule;
  rule.here = (1 - t) * (a - 5 * q);
  rule.next = t * (a - 5 * q);
  rule.mean = 3 * q;
  rule.cosine = 2 * q * ((1 - t) + t * std::cos(angle));
  rule.sine = 2 * q * t * std::sin(angle);
  return rule;
}

bool within(double x, double low, double high) {
  return x >= low && x <= high;
}

Result<void> check(const AklemanOptions& options) {
  const auto badTension = [](double a) {
    return fail(ErrorCode::invalidOption, fmt::format("tension {} is out of range; it must lie in (0, 1)", a));
  };
  const auto tensionOk = [](double a) { return a > 0 && a < 1; };
  if (options.tension.rule == Tension::Rule::constant && !tensionOk(options.tension.value)) {
    return badTension(options.tension.value);
  }
  for (const auto& entry : options.tension.bySides) {
    if (!tensionOk(entry.second)) return badTension(entry.second);
  }
  if (!within(options.edgeParameter, 0, 1)) {
    return fail(ErrorCode::invalidOption,
                fmt::format("edge parameter {} is out of range; it must lie in [0, 1]", options.edgeParameter));
  }
  if (!within(options.boundaryWeight, 0, 1)) {
    return fail(ErrorCode::invalidOption,
                fmt::format("boundary weight {} is out of range; it must lie in [0, 1]", options.boundaryWeight));
  }
  return {};
}

}  // namespace

double Tension::at(std::int32_t sides) const {
  if (const auto own = bySides.find(sides); own != bySides.end()) return own->second;
  switch (rule) {
    case Rule::paper:
      return 0.45 + 1.25 / sides;
    case Rule::sqrt3:
      return sqrt3Tension(sides);
    case Rule::topmod:
      return 1 / std::numbers::sqrt2 - 0.25 + 1.25 / sides;
    case Rule::constant:
      return value;
  }
  return value;
}

Result<Scheme> akleman(const AklemanOptions& options) {
  if (auto checked = check(options); !checked) return tl::unexpected(checked.error());
  Scheme scheme;
  scheme.name = "akleman";
  scheme.split = zip(options.boundary);
  scheme.creases = zipCreases(options.boundary);
  scheme.faceRule = [tension = options.tension, t = options.edgeParameter](std::int32_t sides) {
    return aklemanRule(tension.at(sides), t, sides);
  };
  scheme.pointRow = [s = options.boundaryWeight](const SourceLevel& parent, const NewPoint& point, Row& row) {
    addZipBoundaryRow(parent.topology(), point, s, row);
  };
  return scheme;
}

}  // namespace honeycomb::Far
