#include "far/tables/chart_sums.h"

#include "far/base/index.h"

namespace honeycomb::Far {

void ChartSums::name(std::size_t i, std::int32_t face, std::int32_t number, const std::int32_t* values) {
  Face& large = faces_[i];
  large.face = face;
  large.number = number;
  const std::int32_t projections = rows_.table().projected[i].outputs > 0 ? 3 : 1;
  for (std::int32_t projection = 0; projection < projections; ++projection) {
    std::int32_t j = 0;
    rows_.visitSum({static_cast<std::int32_t>(i), projection}, [&](std::int32_t, double weight) {
      large.weights[at(projection)] += weight;
      if (projection == 0 && charts_.hasSeams() && charts_.planar()) large.mean += weight * charts_.value(values[j++]);
    });
  }
  large.mean /= large.weights[0];
}

Charts::Place ChartSums::place(const Face& face, std::int32_t chart, std::span<const std::int32_t> pivots) const {
  Charts::Place place;
  place.face = face.face;
  if (face.face < 0 || face.face == chart || !charts_.hasSeams()) return place;
  return charts_.findFace(face.face, pivots);
}

}  // namespace honeycomb::Far
