#include "far/tables/chart_sums.h"

#include <algorithm>
#include <map>

#include "far/base/index.h"

namespace honeycomb::Far {

namespace {

/// What a part reads of the sum it belongs to.
struct ReadCorners {
  std::vector<std::int32_t> values;
  std::vector<double> weights;
  void add(std::int32_t value, double weight) {
    values.push_back(value);
    weights.push_back(weight);
  }
};

/// A large face without outputs, whose first two weights are read by none. Returns its number.
std::int32_t addSum(const ReadCorners& read, LevelTable& table) {
  table.projected.push_back({static_cast<std::int32_t>(read.values.size()), 0, 0,
                             static_cast<std::int32_t>(table.indices.size()), 0,
                             static_cast<std::int32_t>(table.weights.size())});
  table.indices.edit().append(read.values.begin(), read.values.end());
  table.weights.resize(table.weights.size() + 2, 0.0);
  table.weights.append(read.weights.begin(), read.weights.end());
  return static_cast<std::int32_t>(table.projected.size()) - 1;
}

std::int32_t projectionsOf(const ProjectedFace& face) {
  return face.outputs > 0 ? 3 : 1;
}

}  // namespace

ChartSums::Part ChartSums::partOf(std::int32_t face, std::span<const std::int32_t> values,
                                  std::span<const double> weights) const {
  Part part;
  part.face = face;
  const bool valued = charts_.hasSeams() && charts_.planar();
  for (std::size_t j = 0; j < weights.size(); ++j) {
    part.weight += weights[j];
    if (valued) part.sum += weights[j] * charts_.value(values[j]);
  }
  return part;
}

void ChartSums::name(std::size_t i, std::int32_t face, std::int32_t number, const std::int32_t* values) {
  const ProjectedFace& large = rows_.table().projected[i];
  for (std::int32_t projection = 0; projection < projectionsOf(large); ++projection) {
    std::vector<double> weights;
    rows_.visitSum({static_cast<std::int32_t>(i), projection},
                   [&](std::int32_t, double weight) { weights.push_back(weight); });
    Part part = partOf(face, {values, at(large.corners)}, weights);
    if (projection == 0) part.number = number;
    faces_[i][at(projection)].parts = {part};
  }
}

void ChartSums::split(std::size_t i, LevelTable& table) {
  const std::vector<std::int32_t> corners = cornersOf(i);
  for (std::int32_t p = 0; p < projectionsOf(rows_.table().projected[i]); ++p) {
    splitSum({static_cast<std::int32_t>(i), p}, corners, table);
  }
}

/// Half-edges of the level before at which a large face's points are corners: one face's as long as they are, then
/// those of the face in which the next two follow each other.
std::vector<std::int32_t> ChartSums::cornersOf(std::size_t i) const {
  const Topology& old = charts_.topology();
  const ProjectedFace& large = rows_.table().projected[i];
  const auto point = [&](std::int32_t j) { return rows_.table().indices[at(large.firstIndex + j)]; };
  const auto start = [&](std::int32_t j) {
    const std::int32_t next = j + 1 < large.corners ? point(j + 1) : -1;
    for (const std::int32_t h : old.halfEdgesFrom(point(j))) {
      if (old.dest(h) == next) return h;
    }
    return old.outgoing(point(j));
  };
  std::vector<std::int32_t> corners;
  for (std::int32_t j = 0; j < large.corners; ++j) {
    std::int32_t corner = -1;
    if (j > 0) {
      const std::int32_t next = old.next(corners.back());
      corner = old.vert(next) == point(j) ? next : charts_.cornerOf(point(j), old.face(next));
    }
    corners.push_back(corner < 0 ? start(j) : corner);
  }
  return corners;
}

void ChartSums::splitSum(const LevelRows::Sum& sum, std::span<const std::int32_t> corners, LevelTable& table) {
  std::map<std::int32_t, ReadCorners> reads;  // by face
  ReadCorners all;
  auto corner = corners.begin();
  rows_.visitSum(sum, [&](std::int32_t, double weight) {
    const std::int32_t value = charts_.corner(*corner);
    reads[charts_.topology().face(*corner++)].add(value, weight);
    all.add(value, weight);
  });
  Parted& parted = faces_[at(sum.face)][at(sum.projection)];
  const bool many = reads.size() > kManyParts;
  for (const auto& entry : reads) {
    Part part = partOf(entry.first, entry.second.values, entry.second.weights);
    if (!many) part.number = addSum(entry.second, table);
    parted.weight += part.weight;
    parted.parts.push_back(part);
  }
  if (!many) return;
  parted.whole = addSum(all, table);
  firstOfMany_.insert(reads.begin()->first);
}

}  // namespace honeycomb::Far
