#include "far/tables/charts.h"

#include <gtest/gtest.h>

#include <array>
#include <complex>
#include <cstdint>
#include <vector>

#include "tests/support/refined.h"
#include "tests/support/shapes.h"

// Faces seen from the charts of others round a vertex.
namespace honeycomb::Test {
namespace {

using Far::Charts;
using Complex = std::complex<double>;

Complex flat(const Vec3& p) {
  return {p[0], p[1]};
}

/// A wheel whose every face is a chart of its own: the same plane, turned, scaled and moved.
class TurnedWheel {
 public:
  explicit TurnedWheel(std::size_t n) : mesh_(wheel(n)), topology_(toTopology(mesh_)) {
    for (std::int32_t h = 0; h < topology_.halfEdgeCount(); ++h) {
      const Complex z = inChartOf(topology_.face(h), flat(at(mesh_.points, topology_.vert(h))));
      corners_.push_back(h);
      values_.insert(values_.end(), {z.real(), z.imag()});
    }
  }
  TurnedWheel(const TurnedWheel&) = delete;
  TurnedWheel& operator=(const TurnedWheel&) = delete;

  const Far::Topology& topology() const { return topology_; }
  const std::vector<Vec3>& points() const { return mesh_.points; }
  Charts charts() const { return {topology_, corners_, values_, 2, -1, true}; }
  static Complex inChartOf(std::int32_t face, Complex z) {
    return std::polar(1.0 + 0.2 * (face % 3), 1.0 * (face % 5)) * z + Complex(face % 7, face % 4);
  }
  std::int32_t hub() const {
    for (const std::int32_t h : topology_.halfEdgesOf(0)) {
      if (!topology_.onBoundary(topology_.vert(h))) return topology_.vert(h);
    }
    return -1;
  }

  /// Looks for all faces from the chart of the hub's first, and from there for their vertices at the rim. Returns the
  /// edges it took.
  std::int64_t expectEachFound() const {
    const Charts charts = this->charts();
    const std::array<std::int32_t, 1> pivot{topology_.outgoing(hub())};
    const std::int32_t first = topology_.face(pivot[0]);
    std::int64_t walked = 0;
    const auto expectHere = [&](const Charts::Place& place, std::int32_t h) {
      walked += place.walked;
      ASSERT_GE(place.face, 0) << "half-edge " << h;
      const Complex seen = place.toChart[0] * charts.value(h) + place.toChart[1];
      const Complex expected = inChartOf(first, flat(at(mesh_.points, topology_.vert(h))));
      ASSERT_LT(std::abs(seen - expected), 1e-9) << "half-edge " << h << " in face " << place.face;
    };
    for (const std::int32_t h : topology_.halfEdgesFrom(hub())) {
      if (h == pivot[0]) continue;
      expectHere(charts.findFace(topology_.face(h), pivot), h);
      const Charts::Place place = charts.findVertex(topology_.dest(h), pivot);
      expectHere(place, place.corner);
      EXPECT_EQ(topology_.vert(place.corner), topology_.dest(h));
    }
    return walked;
  }

 private:
  PolyMesh mesh_;
  Far::Topology topology_;
  std::vector<std::int32_t> corners_;
  std::vector<double> values_;
};

TEST(Charts, GoOnRoundAVertexOfFewFacesAndOfMany) {
  for (const std::size_t n : {5U, 16U, 17U, 40U}) {
    SCOPED_TRACE(n);
    TurnedWheel(n).expectEachFound();
  }
}

TEST(Charts, WalkRoundAVertexOfManyFacesOnce) {
  EXPECT_GT(TurnedWheel(16).expectEachFound(), 0);
  EXPECT_EQ(TurnedWheel(100).expectEachFound(), 0) << "edges walked over again";
}

TEST(Charts, SeeAFaceThatIsNotMetRoundTheirCornersOverOneThatIs) {
  const TurnedWheel wheel(40);
  const Charts charts = wheel.charts();
  const Far::Topology& t = wheel.topology();
  const std::array<std::int32_t, 1> atHub{t.outgoing(wheel.hub())};
  const std::int32_t first = t.face(atHub[0]);
  std::int32_t seen = 0;
  for (const std::int32_t spoke : t.halfEdgesFrom(wheel.hub())) {
    const std::array<std::int32_t, 1> atRim{t.next(spoke)};  // two faces, perhaps not the first
    const std::int32_t from = t.face(spoke);
    if (from == first || charts.findFace(first, atRim).face >= 0) continue;
    const Charts::Walk way = charts.findOver(atRim, charts.walkRound(atHub));
    ASSERT_EQ(way.place.face, first);
    ASSERT_TRUE(way.place.continued);
    EXPECT_FALSE(way.place.plain);
    for (const std::int32_t h : t.halfEdgesOf(first)) {
      const Complex here = way.place.toChart[0] * charts.value(h) + way.place.toChart[1];
      EXPECT_LT(std::abs(here - TurnedWheel::inChartOf(from, flat(at(wheel.points(), t.vert(h))))), 1e-9);
    }
    ++seen;
  }
  EXPECT_EQ(seen, 38);
}

/// Edges that are walked over from each face round the hub to the next, in both directions.
std::int64_t walkedToNeighbours(std::size_t n) {
  const TurnedWheel wheel(n);
  const Charts charts = wheel.charts();
  const Far::Topology& t = wheel.topology();
  std::int64_t walked = 0;
  for (const std::int32_t h : t.halfEdgesFrom(wheel.hub())) {
    for (const std::int32_t spoke : {h, t.twin(h)}) {
      const std::array<std::int32_t, 2> ends{spoke, t.next(spoke)};
      const Charts::Place place = charts.findFace(t.face(t.twin(spoke)), ends);
      EXPECT_GE(place.face, 0);
      walked += place.walked;
    }
  }
  return walked;
}

TEST(Charts, FindTheNextFaceWithoutWalkingAllRound) {
  EXPECT_LE(walkedToNeighbours(400), 4 * walkedToNeighbours(100) + 100);
}

}  // namespace
}  // namespace honeycomb::Test
