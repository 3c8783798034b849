#include "far/tables/face_sums.h"

#include "far/base/index.h"

namespace honeycomb::Far {

FaceSums::FaceSums(const LevelTable& table, Rename rename) : table_(table), rename_(std::move(rename)) {
  for (std::size_t f = 0; f < table.projected.size(); ++f) {
    const auto face = static_cast<std::int32_t>(f);
    faces_.emplace(endsOf(table, face), face);
  }
}

FaceSums::Ends FaceSums::endsOf(const LevelTable& table, std::int32_t face) const {
  const std::int32_t first = table.projected[at(face)].firstIndex;
  const bool single = table.projected[at(face)].corners < 2;
  return {renamed(table.indices[at(first)]), renamed(table.indices[at(single ? first : first + 1)])};
}

PointSum FaceSums::pointsOf(const LevelTable& table, const LevelRows::Sum& sum) const {
  PointSum points;
  LevelRows::visitSum(table, sum, [&](std::int32_t point, double weight) {
    points.points.push_back(renamed(point));
    points.weights.push_back(weight);
  });
  return points;
}

void FaceSums::append(const LevelRows& rows, std::int32_t output, double share, Row& row) {
  rows.visitApart(
      output,
      [&](std::int32_t point, double weight) {
        row.push_back({renamed(point), share * weight});
      },
      [&](const LevelRows::Sum& sum, double weight) {
        row.push_back({table_.sourceCount + number(rows.table(), sum), share * weight});
      });
}

std::int32_t FaceSums::number(const LevelTable& table, const LevelRows::Sum& sum) {
  const std::tuple key(&table, sum.face, sum.projection);
  if (const auto known = numbers_.find(key); known != numbers_.end()) return known->second;
  const std::int32_t found = find(table, sum);
  numbers_.emplace(key, found);
  return found;
}

std::int32_t FaceSums::find(const LevelTable& table, const LevelRows::Sum& sum) {
  const bool own = &table == &table_;
  if (own && sum.projection == 0) return sum.face;
  PointSum points = pointsOf(table, sum);
  if (!own) {
    const auto alike = faces_.find(endsOf(table, sum.face));
    if (alike != faces_.end()) {
      if (const std::int32_t n = findOwn({alike->second, sum.projection}, points); n >= 0) return n;
    }
  }
  added_.push_back(std::move(points));
  return static_cast<std::int32_t>(table_.projected.size() + added_.size()) - 1;
}

/// The number of a sum of the table itself, if it is made of these points; else -1.
std::int32_t FaceSums::findOwn(const LevelRows::Sum& sum, const PointSum& points) {
  const ProjectedFace& face = table_.projected[at(sum.face)];
  const bool there = sum.projection == 0 || face.outputs > 0;
  if (!there || at(face.corners) != points.points.size() || !(pointsOf(table_, sum) == points)) return -1;
  return number(table_, sum);
}

}  // namespace honeycomb::Far
