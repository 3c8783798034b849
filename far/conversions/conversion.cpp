#include "far/conversions/conversion.h"

#include <fmt/format.h>

#include "far/base/index.h"
#include "far/base/parallel.h"

namespace honeycomb::Far {
namespace {

void applyRow(const WeightedRows& rows, std::int64_t row, std::span<const double> values, std::span<double> point) {
  for (std::size_t k = 0; k < point.size(); ++k) {
    double sum = 0;
    for (std::int64_t b = rows.offsets[at(row)]; b < rows.offsets[at(row) + 1]; ++b)
      sum += rows.weights[at(b)] * values[point.size() * at(rows.indices[at(b)]) + k];
    point[k] = sum;
  }
}

}  // namespace

Result<std::vector<double>> apply(const Conversion& conversion, std::span<const double> values, std::int32_t length) {
  if (length < 1) return fail(ErrorCode::invalidOption, fmt::format("{} numbers a vertex; give at least one", length));
  if (values.size() != at(length) * at(conversion.sourceCount))
    return fail(ErrorCode::invalidOption,
                fmt::format("{} numbers given for {} vertices of {} numbers each; give {}", values.size(),
                            conversion.sourceCount, length, at(length) * at(conversion.sourceCount)));
  std::vector<double> points(at(length) * at(conversion.polygons.vertexCount));
  Parallel::forEach(0, conversion.polygons.vertexCount, [&](std::int64_t v) {
    applyRow(conversion.rows, v, values, std::span(points).subspan(at(length) * at(v), at(length)));
  });
  if (!conversion.correction) return points;
  if (const Result<void> corrected = conversion.correction(values, length, points); !corrected)
    return tl::unexpected(corrected.error());
  return points;
}

}  // namespace honeycomb::Far
