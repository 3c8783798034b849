// Points and normals of tiles by every set of instructions that this machine has, past the caches and into them: the
// bits of the plain loops, wherever in a cache line the targets begin, and not a number beside them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <vector>

#include "osd/tile_evaluator.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/must.h"
#include "tests/support/refined.h"
#include "tests/support/scheme_list.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

constexpr std::int64_t kNeverStreamed = std::int64_t{1} << 60;
constexpr std::size_t kLineNumbers = 16;
constexpr float kGuard = -12345.5F;
/// In a cache line where targets begin; sanitizers get two of them.
constexpr std::uint64_t kBeginnings = meshes(kLineNumbers);

/// Closed and open parts with faces of 3 to 9 sides, enough of each for vectors of them and some left over, and of 64.
PolyMesh facesOfAllSides() {
  PolyMesh mesh;
  for (std::size_t sides = 3; sides <= 9; ++sides) {
    for (int copy = 0; copy < 5; ++copy) {
      PolyMesh part = prism(sides);
      if (copy == 2) part.faces.pop_back();
      append(mesh, part);
    }
  }
  for (const PolyMesh& part : {grid(7, 5), torus(5, 4), wheel(5), fan(4), prism(64)}) append(mesh, part);
  return mesh;
}

/// A target amid numbers that belong to others; it begins `begin` numbers behind the beginning of a cache line.
class GuardedTarget {
 public:
  GuardedTarget(std::int64_t count, std::size_t begin) : count_(static_cast<std::size_t>(count)) {
    numbers_.assign(count_ + 4 * kLineNumbers, kGuard);
    const std::size_t inLine = reinterpret_cast<std::uintptr_t>(numbers_.data()) / sizeof(float) % kLineNumbers;
    begin_ = 2 * kLineNumbers - inLine + begin;
  }
  std::span<float> target() { return std::span(numbers_).subspan(begin_, count_); }
  bool has(const std::vector<float>& expected) {
    return expected.size() == count_ && std::memcmp(target().data(), expected.data(), count_ * sizeof(float)) == 0;
  }
  bool othersAreUntouched() const {
    const std::span<const float> all = numbers_;
    const auto isGuard = [](float x) { return x == kGuard; };
    return std::ranges::all_of(all.first(begin_), isGuard) &&
           std::ranges::all_of(all.subspan(begin_ + count_), isGuard);
  }

 private:
  std::vector<float> numbers_;
  std::size_t begin_ = 0;
  std::size_t count_;
};

/// Points of three or four numbers, of chosen tiles or all; the normals that the tiles were built with.
struct Wanted {
  const Far::Refinement& refinement;
  const Far::TileTable& tiles;
  std::int32_t length;
  std::optional<std::span<const std::int32_t>> only;
  std::vector<float> control;

  Wanted(const Far::Refinement& r, const Far::TileTable& t, std::int32_t numbers,
         std::optional<std::span<const std::int32_t>> chosen)
      : refinement(r), tiles(t), length(numbers), only(chosen) {
    Random random(21);
    control.resize(at(length) * at(r.level(0).pointCount()));
    for (float& x : control) x = static_cast<float>(random.symmetric());
  }
  static std::size_t at(std::int32_t n) { return static_cast<std::size_t>(n); }
  std::int64_t pointNumbers() const { return std::int64_t{length} * refinement.last().pointCount(); }
  std::int64_t normalNumbers() const {
    return tiles.normalKind == Far::TileNormalKind::none ? 0 : std::int64_t{3} * refinement.last().pointCount();
  }

  void evaluate(const Osd::TileEvaluatorOptions& options, std::span<float> points, std::span<float> normals) const {
    const Osd::BufferDescriptor packed{0, length, length};
    Osd::TileEvaluator evaluator(options);
    const auto done = evaluator.evaluate<float>(refinement, tiles, tiles.lastLevel, {control, packed}, {points, packed},
                                                {{normals, {}}, only});
    ASSERT_TRUE(done.has_value()) << done.error().message;
  }
};

/// Past the caches: all, both for what they take together, what is larger of both; into the caches.
std::vector<Osd::TileEvaluatorOptions> waysToTheTarget(const Wanted& wanted) {
  const auto pointBytes = wanted.pointNumbers() * std::int64_t{sizeof(float)};
  using Threads = Osd::CpuEvaluator::Threads;
  const auto vectors = Osd::CpuEvaluator::Instructions::vectors;
  return {{Threads::one, vectors, 0, kNeverStreamed},
          {Threads::all, vectors, kNeverStreamed, 0},
          {Threads::one, vectors, pointBytes, kNeverStreamed},
          {Threads::one, vectors, kNeverStreamed, kNeverStreamed}};
}

void expectThePlainBits(const Wanted& wanted, std::uint64_t beginnings) {
  std::vector<float> points(static_cast<std::size_t>(wanted.pointNumbers()), kGuard);
  std::vector<float> normals(static_cast<std::size_t>(wanted.normalNumbers()), kGuard);
  wanted.evaluate({Osd::CpuEvaluator::Threads::one, Osd::CpuEvaluator::Instructions::plain}, points, normals);
  ASSERT_EQ(std::ranges::count(points, kGuard) > 0, wanted.only.has_value());
  for (const Osd::TileEvaluatorOptions& options : waysToTheTarget(wanted)) {
    const bool streamed = options.streamedBytes < kNeverStreamed || options.cachedBytes < kNeverStreamed;
    for (std::size_t k = 0; k < (streamed ? beginnings : 1); ++k) {
      GuardedTarget pointsOut(wanted.pointNumbers(), (7 * k + 1) % kLineNumbers);
      GuardedTarget normalsOut(wanted.normalNumbers(), (5 * k + 2) % kLineNumbers);
      wanted.evaluate(options, pointsOut.target(), normalsOut.target());
      SCOPED_TRACE(testing::Message() << "length " << wanted.length << ", streamed from " << options.streamedBytes
                                      << ", cached to " << options.cachedBytes << ", beginning " << k);
      ASSERT_TRUE(pointsOut.has(points)) << "points differ";
      ASSERT_TRUE(normalsOut.has(normals)) << "normals differ";
      ASSERT_TRUE(pointsOut.othersAreUntouched()) << "beside the points";
      ASSERT_TRUE(normalsOut.othersAreUntouched()) << "beside the normals";
    }
  }
}

std::vector<Far::TileTable> tablesOf(const Far::Refinement& refinement, Far::TileNormalKind normals) {
  std::vector<Far::TileTable> tables;
  for (const auto order : {Far::TileOrder::levels, Far::TileOrder::tiles}) {
    for (const auto places : {Far::TilePlaces::faces, Far::TilePlaces::fours}) {
      tables.push_back(must(Far::buildTileTable(
          refinement, {.scratchPoints = 2000, .order = order, .normals = normals, .places = places})));
    }
  }
  return tables;
}

void expectOfAllTables(const Far::Refinement& refinement, Far::TileNormalKind normals, std::uint64_t beginnings,
                       bool someTiles) {
  for (const Far::TileTable& tiles : tablesOf(refinement, normals)) {
    SCOPED_TRACE(testing::Message() << (tiles.order == Far::TileOrder::tiles ? "tile" : "level") << " order, fours "
                                    << (tiles.places == Far::TilePlaces::fours));
    std::vector<std::int32_t> odd;
    for (std::int32_t t = 1; t < std::ssize(tiles.tiles); t += 2) odd.push_back(t);
    ASSERT_TRUE(!someTiles || !odd.empty());
    const auto only = someTiles ? std::optional<std::span<const std::int32_t>>(odd) : std::nullopt;
    for (const std::int32_t length : {3, 4}) {
      const Wanted wanted(refinement, tiles, length, only);
      forEachTarget([&] { ASSERT_NO_FATAL_FAILURE(expectThePlainBits(wanted, beginnings)); });
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

Far::Refinement refinedOfAllSides() {
  return refined(facesOfAllSides(), schemeCase(NamedTension::paper).scheme, 3, {}, true);
}

class TileStreams : public testing::TestWithParam<Far::TileNormalKind> {};

TEST(TileStream, IsOfFacesOfAllSides) {
  const Far::Refinement refinement = refinedOfAllSides();
  for (const Far::TileTable& tiles : tablesOf(refinement, Far::TileNormalKind::none)) {
    for (std::int32_t sides = 3; sides <= 9; ++sides) {
      const bool fillsVectors = std::ranges::any_of(tiles.steps, [&](const Far::TileStep& step) {
        return step.kind == Far::TileStep::Kind::circulant && step.width == sides && step.count > 4;
      });
      EXPECT_TRUE(fillsVectors) << sides << " sides";
    }
  }
}

TEST_P(TileStreams, WriteThePlainBitsAndNothingBeside) {
  expectOfAllTables(refinedOfAllSides(), GetParam(), kBeginnings, false);
}

TEST_P(TileStreams, OfChosenTilesLeaveThePointsOfOthers) {
  expectOfAllTables(refinedOfAllSides(), GetParam(), std::min<std::uint64_t>(kBeginnings, 4), true);
}

TEST_P(TileStreams, WriteThePlainBitsUnderEveryScheme) {
  for (const ListedScheme& scheme : listedSchemes()) {
    SCOPED_TRACE(scheme.name);
    const Far::Refinement refinement = refinedBy(scheme, toTopology(grid(8, 7)), 2, true);
    ASSERT_NO_FATAL_FAILURE(expectOfAllTables(refinement, GetParam(), 1, false));
  }
}

INSTANTIATE_TEST_SUITE_P(Of, TileStreams,
                         testing::Values(Far::TileNormalKind::none, Far::TileNormalKind::fast,
                                         Far::TileNormalKind::exact),
                         [](const auto& kind) {
                           return kind.param == Far::TileNormalKind::none   ? "points"
                                  : kind.param == Far::TileNormalKind::fast ? "fastNormals"
                                                                            : "exactNormals";
                         });

}  // namespace
}  // namespace honeycomb::Test
