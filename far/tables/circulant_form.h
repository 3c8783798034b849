#pragma once

#include <vector>

#include "far/tables/level_table.h"

namespace honeycomb::Far {

/// The cheapest form that a first row of 3 to kLargestCirculant weights allows. A row is taken for its own mirror image
/// where it differs from it by no more than rounding.
CirculantForm circulantForm(const std::vector<double>& row);

/// The weights of a form of a row that allows it: formWeightCount of them, in the order of CirculantForm.
std::vector<double> formWeights(CirculantForm form, const std::vector<double>& row);

}  // namespace honeycomb::Far
