#pragma once

#include <functional>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "far/tables/level_rows.h"
#include "far/tables/replaced_rows.h"

namespace honeycomb::Far {

/// New rows for a table that are put together from rows of it and of tables like it, without spelling out what these
/// read of all corners of large faces: N rows beside a face of N sides cost O(N).
class FaceSums {
 public:
  using Rename = std::function<std::int32_t(std::int32_t)>;

  /// `table`: whose rows are to be replaced, before replaceRows(). `rename`: what the new rows read in the place of a
  /// point of the tables; none: the point. Linear in the large faces.
  explicit FaceSums(const LevelTable& table, Rename rename = {});

  /// Appends `share` times the row of an output, with sums as ReplacedRow has them. A sum that `rows` shares with the
  /// table, point by point, has one number.
  void append(const LevelRows& rows, std::int32_t output, double share, Row& row);

  /// Those that the table doesn't have, for RowChanges.
  std::vector<PointSum> added() && { return std::move(added_); }

 private:
  using Ends = std::pair<std::int32_t, std::int32_t>;

  std::int32_t renamed(std::int32_t point) const { return rename_ ? rename_(point) : point; }
  std::int32_t number(const LevelTable& table, const LevelRows::Sum& sum);
  std::int32_t find(const LevelTable& table, const LevelRows::Sum& sum);
  std::int32_t findOwn(const LevelRows::Sum& sum, const PointSum& points);
  PointSum pointsOf(const LevelTable& table, const LevelRows::Sum& sum) const;
  Ends endsOf(const LevelTable& table, std::int32_t face) const;

  const LevelTable& table_;
  Rename rename_;
  std::map<Ends, std::int32_t> faces_;  // the table's large faces by their first two points
  std::map<std::tuple<const LevelTable*, std::int32_t, std::int32_t>, std::int32_t> numbers_;  // by face, projection
  std::vector<PointSum> added_;
};

}  // namespace honeycomb::Far
