#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "far/base/index.h"
#include "far/tables/level_rows.h"

namespace honeycomb::Far {

/// A sparse combination of the points of one level: `Lanes` weights a point, held densely, with the list of the points
/// that have any. With no lanes it is the set of points alone.
template <std::size_t Lanes>
class SparsePoints {
 public:
  using Weights = std::array<double, Lanes>;

  explicit SparsePoints(std::int32_t pointCount) : weights_(at(pointCount)), marked_(at(pointCount), 0) {}

  void add(std::int32_t point, double scale, const Weights& weights) {
    if (!marked_[at(point)]) {
      marked_[at(point)] = 1;
      touched_.push_back(point);
    }
    Weights& sum = weights_[at(point)];
    for (std::size_t lane = 0; lane < Lanes; ++lane) sum[lane] += scale * weights[lane];
  }

  /// In the order in which they were first touched.
  const std::vector<std::int32_t>& touched() const { return touched_; }
  const Weights& weights(std::int32_t point) const { return weights_[at(point)]; }

  void clear() {
    for (const std::int32_t point : touched_) {
      marked_[at(point)] = 0;
      weights_[at(point)] = {};
    }
    touched_.clear();
  }

 private:
  std::vector<Weights> weights_;
  std::vector<std::uint8_t> marked_;
  std::vector<std::int32_t> touched_;
};

/// Carries combinations of points down a chain of level tables to the control points: the composed row of a point,
/// without composing the rows of any other. A row costs the sum over the levels of the entries of the rows it touches;
/// the rows of a large face, however many are touched, are taken through its three sums, in time linear in its corners.
///
/// Order of the sums: the points of a level in the order in which they were first touched, the entries of each in the
/// order of LevelRows::visit; what goes through the sums of large faces comes after all else, in the order in which the
/// faces were first touched.
template <std::size_t Lanes>
class Composer {
 public:
  using Weights = typename SparsePoints<Lanes>::Weights;

  /// `chain`: the tables from the last to the first; a table's sources are the next one's targets.
  explicit Composer(std::span<const LevelRows* const> chain) : chain_(chain.begin(), chain.end()) {
    std::size_t faces = 0;
    for (const LevelRows* rows : chain_) {
      levels_.emplace_back(rows->rowCount());
      faces = std::max(faces, rows->table().projected.size());
    }
    levels_.emplace_back(chain_.back()->table().sourceCount);
    sums_.resize(faces);
    touchedFace_.resize(faces, 0);
  }

  /// Adds to the combination that compose() carries down: of targets of table `step` of the chain.
  void add(std::size_t step, std::int32_t point, const Weights& weights) { levels_[step].add(point, 1, weights); }

  /// The same combination in control points, to be read until it is cleared.
  const SparsePoints<Lanes>& compose() {
    for (std::size_t step = 0; step < chain_.size(); ++step) carry(*chain_[step], levels_[step], levels_[step + 1]);
    return levels_.back();
  }
  void clear() { levels_.back().clear(); }

 private:
  struct FaceSums {
    Weights sum{}, cosine{}, sine{};
  };

  void carry(const LevelRows& rows, SparsePoints<Lanes>& from, SparsePoints<Lanes>& to) {
    for (const std::int32_t point : from.touched()) {
      const Weights& weights = from.weights(point);
      const LevelRows::Place place = rows.place(point);
      if (place.kind == LevelRows::Kind::projected) {
        collect(rows.table(), place, weights, to);
      } else if (place.kind == LevelRows::Kind::summed) {
        collectSummed(rows, place.item, weights, to);
      } else {
        rows.visit(point, [&](std::int32_t source, double w) { to.add(source, w, weights); });
      }
    }
    for (const std::int32_t face : faces_) spread(rows.table(), face, to);
    faces_.clear();
    from.clear();
  }

  /// An output of a large face: its own two corners now, its share of the sums later.
  void collect(const LevelTable& table, const LevelRows::Place& place, const Weights& weights,
               SparsePoints<Lanes>& to) {
    const ProjectedFace& face = table.projected[at(place.batch)];
    const double* w = table.weights.data() + face.firstWeight;
    const double* x = w + 2 + 3 * std::int64_t{face.corners} + place.row;
    const std::int32_t a = (face.firstCorner + place.row) % face.corners;
    const std::int32_t b = a + 1 == face.corners ? 0 : a + 1;
    to.add(table.indices[at(face.firstIndex + a)], w[0], weights);
    to.add(table.indices[at(face.firstIndex + b)], w[1], weights);
    FaceSums& sums = sums_[at(place.batch)];
    for (std::size_t lane = 0; lane < Lanes; ++lane) {
      sums.sum[lane] += x[0] * weights[lane];
      sums.cosine[lane] += x[face.outputs] * weights[lane];
      sums.sine[lane] += x[2 * std::int64_t{face.outputs}] * weights[lane];
    }
    touchFace(place.batch);
  }

  /// A row with shares of large faces' sums: its own entries now, the shares later.
  void collectSummed(const LevelRows& rows, std::int32_t row, const Weights& weights, SparsePoints<Lanes>& to) {
    rows.visitOwnEntries(row, [&](std::int32_t source, double w) { to.add(source, w, weights); });
    rows.visitShares(row, [&](std::int32_t face, double share) {
      for (std::size_t lane = 0; lane < Lanes; ++lane) sums_[at(face)].sum[lane] += share * weights[lane];
      touchFace(face);
    });
  }

  void touchFace(std::int32_t face) {
    if (touchedFace_[at(face)]) return;
    touchedFace_[at(face)] = 1;
    faces_.push_back(face);
  }

  void spread(const LevelTable& table, std::int32_t number, SparsePoints<Lanes>& to) {
    const ProjectedFace& face = table.projected[at(number)];
    const double* s = table.weights.data() + face.firstWeight + 2;
    const double* c = s + face.corners;
    const double* d = c + face.corners;
    FaceSums& sums = sums_[at(number)];
    for (std::int32_t j = 0; j < face.corners; ++j) {
      if (face.outputs == 0) {
        to.add(table.indices[at(face.firstIndex + j)], s[j], sums.sum);
        continue;
      }
      Weights total{};
      for (std::size_t lane = 0; lane < Lanes; ++lane) {
        total[lane] = (s[j] * sums.sum[lane] + c[j] * sums.cosine[lane]) + d[j] * sums.sine[lane];
      }
      to.add(table.indices[at(face.firstIndex + j)], 1, total);
    }
    sums = {};
    touchedFace_[at(number)] = 0;
  }

  std::vector<const LevelRows*> chain_;
  std::vector<SparsePoints<Lanes>> levels_;  // targets of the chain's tables, then the control points
  std::vector<FaceSums> sums_;
  std::vector<std::uint8_t> touchedFace_;
  std::vector<std::int32_t> faces_;  // those with sums, in the order of first touch
};

}  // namespace honeycomb::Far
