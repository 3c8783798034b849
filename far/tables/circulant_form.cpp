#include "far/tables/circulant_form.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "far/base/index.h"

namespace honeycomb::Far {

namespace {

/// Rows are sums of a few rounded products and cosines, none of them greater than about 1.
constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();

bool mirroredAboutFirstEdge(const std::vector<double>& row) {
  const std::size_t n = row.size();
  double largest = 0;
  for (const double weight : row) largest = std::max(largest, std::abs(weight));
  for (std::size_t k = 1; k <= n / 2; ++k) {
    if (!(std::abs(row[k] - row[(n + 1 - k) % n]) <= kRounding * largest)) return false;
  }
  return true;
}

std::vector<double> evenOddWeights(const std::vector<double>& row) {
  const std::size_t half = row.size() / 2;
  std::vector<double> form(row.size());
  for (std::size_t k = 0; k < half; ++k) {
    form[k] = (row[k] + row[k + half]) / 2;
    form[half + k] = (row[k] - row[k + half]) / 2;
  }
  return form;
}

}  // namespace

CirculantForm circulantForm(const std::vector<double>& row) {
  if (row.size() % 2 != 0) return CirculantForm::direct;
  if (row.size() == 4 && mirroredAboutFirstEdge(row)) return CirculantForm::quad;
  if (row.size() == 6 && mirroredAboutFirstEdge(row)) return CirculantForm::hexagon;
  return CirculantForm::evenOdd;
}

std::vector<double> formWeights(CirculantForm form, const std::vector<double>& row) {
  if (form == CirculantForm::direct) return row;
  const std::vector<double> halves = evenOddWeights(row);
  if (form == CirculantForm::evenOdd) return halves;
  // Equal pairs but for rounding: their means.
  const double even = (halves[0] + halves[1]) / 2;
  const std::size_t odd = row.size() / 2;
  const double difference = (halves[odd] + halves[odd + 1]) / 2;
  if (form == CirculantForm::quad) return {even, difference};
  return {even, even - halves[2], difference};
}

}  // namespace honeycomb::Far
