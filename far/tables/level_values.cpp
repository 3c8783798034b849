#include "far/tables/level_values.h"

#include <array>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/tables/level_rows.h"

namespace honeycomb::Far {

namespace {

class Application {
 public:
  Application(const LevelTable& table, std::span<const double> source, std::int32_t length)
      : table_(table), source_(source), length_(length), target_(at(table.targetCount) * at(length)) {}

  std::vector<double> run() {
    const LevelRows rows(table_);
    sumFaces(rows);
    Parallel::forEach(
        0, table_.targetCount,
        [&](std::int64_t output) {
          const auto o = static_cast<std::int32_t>(output);
          if (rows.place(o).kind == LevelRows::Kind::projected) return;
          rows.visitApart(
              o, [&](std::int32_t p, double w) { add(p, w, o); },
              [&](const LevelRows::Sum& sum, double share) { addSum(sum.face, share, o); });
        },
        256);
    Parallel::forEach(
        0, static_cast<std::int64_t>(table_.projected.size()),
        [&](std::int64_t i) {
          if (table_.projected[at(i)].outputs > 0) project(table_.projected[at(i)]);
        },
        1);
    return std::move(target_);
  }

 private:
  double& target(std::int32_t output, std::int32_t k) { return target_[at(output) * at(length_) + at(k)]; }
  double source(std::int32_t point, std::int32_t k) const { return source_[at(point) * at(length_) + at(k)]; }
  double weight(std::int32_t i) const { return table_.weights[at(i)]; }

  void add(std::int32_t point, double weight, std::int32_t output) {
    for (std::int32_t k = 0; k < length_; ++k) target(output, k) += weight * source(point, k);
  }

  void addSum(std::int32_t face, double share, std::int32_t output) {
    for (std::int32_t k = 0; k < length_; ++k) target(output, k) += share * sums_[at(face) * at(length_) + at(k)];
  }

  /// S of all large faces, where summed rows read them.
  void sumFaces(const LevelRows& rows) {
    if (table_.summed.rowCount() == 0) return;
    sums_.resize(table_.projected.size() * at(length_));
    Parallel::forEach(
        0, std::ssize(table_.projected),
        [&](std::int64_t f) {
          rows.visitSum({static_cast<std::int32_t>(f), 0}, [&](std::int32_t p, double w) {
            for (std::int32_t k = 0; k < length_; ++k) sums_[at(f) * at(length_) + at(k)] += w * source(p, k);
          });
        },
        1);
  }

  /// See ProjectedFace.
  void project(const ProjectedFace& face) {
    const std::int32_t s = face.firstWeight + 2;
    const std::int32_t x = s + 3 * face.corners;
    const auto corner = [&](std::int32_t j) { return table_.indices[at(face.firstIndex + j)]; };
    for (std::int32_t k = 0; k < length_; ++k) {
      std::array<double, 3> sums{};
      for (std::int32_t j = 0; j < face.corners; ++j) {
        for (std::int32_t m = 0; m < 3; ++m) sums[at(m)] += weight(s + m * face.corners + j) * source(corner(j), k);
      }
      for (std::int32_t i = 0; i < face.outputs; ++i) {
        const std::int32_t a = (face.firstCorner + i) % face.corners;
        const std::int32_t b = (a + 1) % face.corners;
        double value = weight(face.firstWeight) * source(corner(a), k);
        value += weight(face.firstWeight + 1) * source(corner(b), k);
        for (std::int32_t m = 0; m < 3; ++m) value += weight(x + m * face.outputs + i) * sums[at(m)];
        target(face.firstOutput + i, k) = value;
      }
    }
  }

  const LevelTable& table_;
  std::span<const double> source_;
  std::int32_t length_;
  std::vector<double> target_;
  std::vector<double> sums_;  // `length` numbers a large face
};

}  // namespace

std::vector<double> applyTable(const LevelTable& table, std::span<const double> source, std::int32_t length) {
  return Application(table, source, length).run();
}

}  // namespace honeycomb::Far
