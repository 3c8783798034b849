#pragma once

#include <array>
#include <complex>
#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "far/tables/charts.h"
#include "far/tables/level_rows.h"

namespace honeycomb::Far {

/// The sums of a level table's large faces, as its face-varying rows read them: of the values of faces of the level
/// before, in whose charts they are, so that N rows round a face of N sides needn't look at its corners one by one.
class ChartSums {
 public:
  /// What a sum reads of one face.
  struct Part {
    std::int32_t face = -1;        ///< of the level before
    std::int32_t number = -1;      ///< in the projected faces of the face-varying table; -1: it isn't there
    double weight = 0;             ///< that it puts on all corners
    std::complex<double> sum = 0;  ///< of their values, where these are planar
  };

  /// `table`: the face-varying table, in which the sums are put; both must outlive it.
  ChartSums(const LevelRows& rows, const Charts& charts)
      : rows_(rows), charts_(charts), faces_(rows.table().projected.size()) {}

  /// Large face `i` of the rows' table reads corners of `face` alone, whose values are `values`, and is number `number`
  /// in the face-varying table, where the sum S stands for it. Linear in its corners.
  void name(std::size_t i, std::int32_t face, std::int32_t number, const std::int32_t* values);
  /// Large face `i` reads corners of several faces, one after the other, or of one that isn't known: puts the sums of
  /// each of them, and where they are many those of all, into the face-varying table. Linear in its corners and the
  /// valences of some.
  void split(std::size_t i, LevelTable& table);

  /// Empty: it has none, and its corners are to be read one by one.
  std::span<const Part> parts(const LevelRows::Sum& sum) const { return of(sum).parts; }
  /// Are its parts so many that a row can't look at each?
  bool manyParts(const LevelRows::Sum& sum) const { return of(sum).parts.size() > kManyParts; }
  /// The number of the sum of all of many parts, each in its own chart.
  std::int32_t whole(const LevelRows::Sum& sum) const { return of(sum).whole; }
  /// Has a face grown together from many, of which this is the first?
  bool firstOfMany(std::int32_t face) const { return firstOfMany_.contains(face); }
  /// What it puts on all corners of many parts.
  double weight(const LevelRows::Sum& sum) const { return of(sum).weight; }
  /// Does it read corners of that face alone?
  bool liesIn(const LevelRows::Sum& sum, std::int32_t face) const {
    return parts(sum).size() == 1 && parts(sum).front().face == face;
  }

 private:
  static constexpr std::size_t kManyParts = 16;
  struct Parted {
    std::vector<Part> parts;
    std::int32_t whole = -1;
    double weight = 0;
  };
  const Parted& of(const LevelRows::Sum& sum) const { return faces_[at(sum.face)][at(sum.projection)]; }

  std::vector<std::int32_t> cornersOf(std::size_t i) const;
  void splitSum(const LevelRows::Sum& sum, std::span<const std::int32_t> corners, LevelTable& table);
  Part partOf(std::int32_t face, std::span<const std::int32_t> values, std::span<const double> weights) const;

  const LevelRows& rows_;
  const Charts& charts_;
  std::vector<std::array<Parted, 3>> faces_;
  std::set<std::int32_t> firstOfMany_;
};

}  // namespace honeycomb::Far
