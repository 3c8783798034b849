#pragma once

#include <array>
#include <complex>
#include <cstdint>
#include <vector>

#include "far/tables/charts.h"
#include "far/tables/level_rows.h"

namespace honeycomb::Far {

/// The sums of a level table's large faces, as its face-varying rows read them: of the values of one face of the level
/// before, in whose chart they are, so that N rows round a face of N sides needn't look at its corners one by one.
class ChartSums {
 public:
  struct Face {
    std::int32_t face = -1;           ///< of the level before; -1: the sum is over corners of several
    std::int32_t number = -1;         ///< in the projected faces of the face-varying table
    std::array<double, 3> weights{};  ///< that S, C and D put on all corners
    std::complex<double> mean = 0;    ///< S over its weight, where values are planar
  };

  ChartSums(const LevelRows& rows, const Charts& charts)
      : rows_(rows), charts_(charts), faces_(rows.table().projected.size()) {}

  /// Large face `i` of the table reads the corners of `face`, whose values are `indices`, and has that number. Linear
  /// in its corners.
  void name(std::size_t i, std::int32_t face, std::int32_t number, const std::int32_t* values);
  const Face& of(const LevelRows::Sum& sum) const { return faces_[static_cast<std::size_t>(sum.face)]; }

  /// Where the chart of `chart` sees the face of a sum; its face is -1 where that isn't one, or not found.
  Charts::Place place(const Face& face, std::int32_t chart, std::span<const std::int32_t> pivots) const;

 private:
  const LevelRows& rows_;
  const Charts& charts_;
  std::vector<Face> faces_;
};

}  // namespace honeycomb::Far
