#include <cmath>
#include <numbers>

#include "far/base/index.h"
#include "far/schemes/scheme.h"

namespace honeycomb::Far {

std::vector<double> firstRow(const CirculantRule& rule, std::int32_t sides) {
  std::vector<double> row(at(sides));
  for (std::int32_t k = 0; k < sides; ++k) {
    const double angle = 2 * std::numbers::pi * k / sides;
    row[at(k)] = rule.mean + rule.cosine * std::cos(angle) + rule.sine * std::sin(angle);
  }
  row[0] += rule.here;
  row[1] += rule.next;
  row[at(sides / 2)] += rule.opposite;
  return row;
}

}  // namespace honeycomb::Far
