#include "io/scene/weld.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "far/base/index.h"

namespace honeycomb::Io {
namespace {

constexpr double kWeightTolerance = 1e-4;  // exporters round weights to 1/255 at worst, but alike along a seam
constexpr int kMostCompared = 256;         // vertices of one place, so that hostile files take no quadratic time

/// A cell of space, its corner in cells as whole numbers in double: any coordinate has one.
std::uint64_t cellHash(const Vector3& cell) {
  std::uint64_t hash = 0;
  for (const double x : cell) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9E3779B97F4A7C15U;  // + 0.0: -0 is 0
    hash ^= hash >> 29U;
  }
  return hash;
}

class Welder {
 public:
  Welder(const Skin& skin, double tolerance) : skin_(skin), tolerance_(tolerance) {}

  Weld run() {
    const std::int64_t count = skin_.vertexCount();
    weld_.representative.resize(at(count));
    next_.resize(at(count), -1);
    for (std::int64_t v = 0; v < count; ++v) weld_.representative[at(v)] = place(static_cast<std::int32_t>(v));
    return std::move(weld_);
  }

 private:
  std::int32_t place(std::int32_t v) {
    const Vector3 point = skin_.position(v);
    std::int32_t found = -1;
    bool disagrees = false;
    const Vector3 low = cellOf(point, -tolerance_), high = cellOf(point, tolerance_);
    for (unsigned corner = 0; corner < 8; ++corner) {
      Vector3 cell = low;
      bool another = true;
      for (std::size_t i = 0; i < 3; ++i) {
        if ((corner >> i & 1U) == 0) continue;
        another = another && high[i] != low[i];
        cell[i] = high[i];
      }
      if (another) search(cell, v, found, disagrees);
    }
    if (found >= 0) return found;
    weld_.disagreeing += disagrees ? 1 : 0;
    const auto [head, fresh] = heads_.try_emplace(cellHash(cellOf(point, 0)), v);
    if (!fresh) next_[at(v)] = std::exchange(head->second, v);
    return v;
  }

  Vector3 cellOf(const Vector3& point, double shift) const {
    if (tolerance_ == 0) return point;
    Vector3 cell;
    for (std::size_t i = 0; i < 3; ++i) cell[i] = std::floor((point[i] + shift) / (2 * tolerance_));
    return cell;
  }

  /// The lowest representative in a cell that v is one with.
  void search(const Vector3& cell, std::int32_t v, std::int32_t& found, bool& disagrees) const {
    const auto head = heads_.find(cellHash(cell));
    std::int32_t other = head == heads_.end() ? -1 : head->second;
    for (int compared = 0; other >= 0 && compared < kMostCompared; other = next_[at(other)], ++compared) {
      if (!near(skin_.position(v), skin_.position(other))) continue;
      if (!movesAlike(v, other)) {
        disagrees = true;
      } else if (found < 0 || other < found) {
        found = other;
      }
    }
  }

  bool near(const Vector3& a, const Vector3& b) const {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) <= tolerance_;
  }

  bool movesAlike(std::int32_t a, std::int32_t b) const {
    const auto sameInfluence = [](const Influence& x, const Influence& y) {
      return x.joint == y.joint && std::abs(x.weight - y.weight) <= kWeightTolerance;
    };
    const auto sameMorph = [this](const MorphOffset& x, const MorphOffset& y) {
      return x.target == y.target && near(x.offset, y.offset);
    };
    const auto influencesA = skin_.influencesOf(a), influencesB = skin_.influencesOf(b);
    const auto morphsA = skin_.morphsOf(a), morphsB = skin_.morphsOf(b);
    return std::equal(influencesA.begin(), influencesA.end(), influencesB.begin(), influencesB.end(), sameInfluence) &&
           std::equal(morphsA.begin(), morphsA.end(), morphsB.begin(), morphsB.end(), sameMorph);
  }

  const Skin& skin_;
  double tolerance_;
  Weld weld_;
  std::unordered_map<std::uint64_t, std::int32_t> heads_;  // of the lists of representatives, by cell
  std::vector<std::int32_t> next_;                         // in its list
};

}  // namespace

Weld weldVertices(const Skin& skin, double tolerance) {
  return Welder(skin, tolerance).run();
}

}  // namespace honeycomb::Io
