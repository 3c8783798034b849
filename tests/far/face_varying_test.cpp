#include "far/tables/face_varying.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

#include "far/schemes/akleman.h"
#include "tests/far/channel.h"
#include "tests/support/random.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"
#include "tests/support/table_rows.h"

namespace honeycomb::Test {
namespace {

using Far::FaceVarying;

const std::vector<std::string> kSchemes{"akleman",          "akleman-eq16", "akleman-drop",    "zhang-wang",
                                        "zhang-wang-brick", "halfbox",      "halfbox-trisect", "halfbox-tuned-all",
                                        "doo-sabin",        "midpoint",     "trisect",         "centroid"};
std::vector<Numbers> levelValues(const FaceVarying& varying, const Channel& channel) {
  std::vector<Numbers> levels{channel.values};
  for (std::int32_t k = 1; k <= varying.levelCount(); ++k) {
    levels.push_back(evaluateChannel(varying.level(k).table, levels.back(), channel.length));
  }
  return levels;
}

/// Numbers of the value at half-edge h.
Numbers valueAt(const Far::FaceVaryingLevel& level, const Numbers& values, std::int32_t h, std::int32_t length) {
  const auto first = values.begin() + std::ptrdiff_t{at(level.corners, h)} * length;
  return {first, first + length};
}

/// A value for each vertex, numbered the other way round.
Channel withVertexValues(const PolyMesh& mesh) {
  Random random(7);
  Channel channel{mesh, Numbers(2 * mesh.points.size()), {}, 2};
  for (double& x : channel.values) x = random.symmetric();
  for (const Loop& loop : mesh.faces) {
    for (const std::size_t v : loop) channel.corners.push_back(static_cast<std::int32_t>(mesh.points.size() - 1 - v));
  }
  return channel;
}

/// The values of the vertices of such a channel.
Numbers inVertexOrder(const Channel& channel) {
  Numbers values;
  for (std::size_t i = channel.values.size(); i > 0; i -= 2) {
    values.insert(values.end(), {channel.values[i - 2], channel.values[i - 1]});
  }
  return values;
}

/// n x m quads round a cylinder, open at both ends; u goes once round it, with a seam where column `seam` begins.
Channel mappedCylinder(std::size_t n, std::size_t m, std::size_t seam = 0) {
  Channel channel;
  for (std::size_t j = 0; j <= m; ++j) {
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(n);
      channel.mesh.points.push_back({std::cos(angle), std::sin(angle), static_cast<double>(j)});
    }
  }
  for (std::size_t j = 0; j < m; ++j) {
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t next = (i + 1) % n;
      channel.mesh.faces.push_back({j * n + i, j * n + next, (j + 1) * n + next, (j + 1) * n + i});
      const std::size_t turn = i < seam ? n : 0;
      const auto u = [&](std::size_t k) { return static_cast<double>(k + turn) / static_cast<double>(n); };
      const auto v = [m](std::size_t k) { return static_cast<double>(k) / static_cast<double>(m); };
      channel.add({u(i), v(j)});
      channel.add({u(i + 1), v(j)});
      channel.add({u(i + 1), v(j + 1)});
      channel.add({u(i), v(j + 1)});
    }
  }
  return channel;
}

/// Every face has a chart of its own: a regular polygon that touches no other.
Channel separateCharts(const PolyMesh& mesh, std::int32_t length) {
  Channel channel{mesh, {}, {}, length};
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t i = 0; i < mesh.faces[f].size(); ++i) {
      const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(mesh.faces[f].size());
      Numbers value{10 * static_cast<double>(f) + std::cos(angle), std::sin(angle), angle};
      value.resize(static_cast<std::size_t>(length));
      channel.add(value);
    }
  }
  return channel;
}

INSTANTIATE_TEST_SUITE_P(Schemes, FaceVaryingBy, testing::ValuesIn(kSchemes), [](const auto& test) {
  std::string name = test.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST_P(FaceVaryingBy, WithoutSeamsGivesTheBitsOfAVertexPrimvar) {
  for (const PolyMesh& mesh : {torus(4, 5), dodecahedron(), grid(4, 5), tetrahedron()}) {
    const Channel channel = withVertexValues(mesh);
    const Far::Refinement refinement = refinedChannel(GetParam(), mesh);
    const FaceVarying varying = builtVarying(refinement, channel);
    const Numbers values = levelValues(varying, channel).back();
    Numbers vertexValues = inVertexOrder(channel);
    for (std::int32_t k = 1; k <= refinement.levelCount(); ++k) {
      vertexValues = evaluateChannel(refinement.level(k).table, vertexValues, 2);
    }
    const Far::Topology& topology = refinement.last().topology;
    for (std::int32_t h = 0; h < topology.halfEdgeCount(); ++h) {
      const auto v = vertexValues.begin() + 2 * std::ptrdiff_t{topology.vert(h)};
      ASSERT_EQ(valueAt(varying.last(), values, h, 2), Numbers(v, v + 2)) << "half-edge " << h;
    }
  }
}

TEST_P(FaceVaryingBy, EveryRowSumsToOne) {
  for (const std::int32_t length : {2, 3}) {
    const Channel channel = separateCharts(cube(), length);
    const FaceVarying varying = builtVarying(refinedChannel(GetParam(), channel.mesh), channel);
    EXPECT_TRUE(varying.hasSeams());
    for (std::int32_t k = 1; k <= varying.levelCount(); ++k) {
      for (const StencilRow& row : expandRows(varying.level(k).table)) {
        const double sum =
            std::accumulate(row.begin(), row.end(), 0.0, [](double s, const auto& e) { return s + e.second; });
        ASSERT_NEAR(sum, 1, 1e-12);
      }
    }
  }
}

/// The value that a corner of the child would have if its face's parent stood in its own mesh; empty for stencils that
/// read other points than the parent's corners.
Numbers ownValue(const StencilRow& row, const Far::Topology& parent, std::int32_t face,
                 const Far::FaceVaryingLevel& level, const Numbers& values) {
  Numbers expected{0, 0};
  for (const auto& entry : row) {
    std::int32_t corner = -1;
    for (std::int32_t c = at(parent.faceOffsets(), face); c < at(parent.faceOffsets(), face + 1); ++c) {
      if (parent.vert(c) == entry.first) corner = c;
    }
    if (corner < 0) return {};
    const Numbers value = valueAt(level, values, corner, 2);
    for (std::size_t i = 0; i < 2; ++i) expected[i] += entry.second * value[i];
  }
  return expected;
}

void expectFacesRefineAlone(const std::string& scheme, const PolyMesh& mesh, std::int32_t levels) {
  const Channel channel = separateCharts(mesh, 2);
  const Far::Refinement refinement = refinedChannel(scheme, mesh, levels);
  const FaceVarying varying = builtVarying(refinement, channel);
  const std::vector<Numbers> values = levelValues(varying, channel);
  std::size_t checked = 0;
  for (std::int32_t k = 1; k <= refinement.levelCount(); ++k) {
    const Far::Topology& child = refinement.level(k).topology;
    const std::vector<StencilRow> rows = expandRows(refinement.level(k).table);
    for (std::int32_t h = 0; h < child.halfEdgeCount(); ++h) {
      const std::int32_t f = child.face(h);
      if (child.parentKind(f) != Far::FaceParent::face) continue;
      const Numbers expected = ownValue(at(rows, child.vert(h)), refinement.level(k - 1).topology,
                                        at(child.parents(), f), varying.level(k - 1), at(values, k - 1));
      if (expected.empty()) continue;
      ++checked;
      const Numbers value = valueAt(varying.level(k), at(values, k), h, 2);
      ASSERT_NEAR(value[0], expected[0], 1e-11) << "level " << k << " half-edge " << h;
      ASSERT_NEAR(value[1], expected[1], 1e-11) << "level " << k << " half-edge " << h;
    }
  }
  std::size_t corners = 0;
  for (const Loop& loop : mesh.faces) corners += loop.size();
  EXPECT_GE(checked, corners);
}

TEST_P(FaceVaryingBy, FacesRefineFromTheirOwnCorners) {
  expectFacesRefineAlone(GetParam(), prism(5), kChannelLevels);
}

TEST(FaceVarying, FacesOfManySidesRefineFromTheirOwnCorners) {
  expectFacesRefineAlone("akleman", prism(100), 2);
}

TEST(FaceVarying, EqualValuesOfNeighbouringCornersAreNoSeam) {
  Channel channel{cube(), {}, {}, 2};
  for (const Loop& loop : channel.mesh.faces) {
    for (const std::size_t v : loop) channel.add({static_cast<double>(v), 1});
  }
  EXPECT_FALSE(builtVarying(refinedChannel("akleman", channel.mesh, 1), channel).hasSeams());
  channel.values[7] = 2;
  EXPECT_TRUE(builtVarying(refinedChannel("akleman", channel.mesh, 1), channel).hasSeams());
}

/// No cell smears the texture: u of neighbouring cells differs by whole turns only, and no cell is wider than it ought.
TEST_P(FaceVaryingBy, SeamOfACylinderIsContinuedAcross) {
  const Channel channel = mappedCylinder(8, 4);
  const Far::Refinement refinement = refinedChannel(GetParam(), channel.mesh);
  const FaceVarying varying = builtVarying(refinement, channel);
  const std::vector<Numbers> values = levelValues(varying, channel);
  for (std::int32_t k = 1; k <= refinement.levelCount(); ++k) {
    const Far::Topology& topology = refinement.level(k).topology;
    std::vector<Numbers> first(static_cast<std::size_t>(topology.vertexCount()));
    double widest = 0;
    for (std::int32_t h = 0; h < topology.halfEdgeCount(); ++h) {
      const Numbers value = valueAt(varying.level(k), at(values, k), h, 2);
      Numbers& known = at(first, topology.vert(h));
      if (known.empty()) known = value;
      const double turns = value[0] - known[0];
      ASSERT_NEAR(turns, std::round(turns), 1e-12) << "level " << k << " vertex " << topology.vert(h);
      ASSERT_NEAR(value[1], known[1], 1e-12);
      const Numbers next = valueAt(varying.level(k), at(values, k), topology.next(h), 2);
      widest = std::max(widest, std::abs(next[0] - value[0]));
    }
    EXPECT_LE(widest, 1.0 / 8) << "level " << k;
  }
}

/// A plane cut into two charts, one turned, scaled and shifted against the other: wherever the corners of a cell lie,
/// all have the values that one of the two charts has there.
TEST_P(FaceVaryingBy, CellsOnASeamContinueTheChartOfTheirFirstFace) {
  Channel channel{grid(6, 6), {}, {}, 2};
  const auto turned = [](double x, double y) { return Numbers{5 - 0.6 * x - 0.8 * y, 7 + 0.8 * x - 0.6 * y}; };
  for (const Loop& loop : channel.mesh.faces) {
    Numbers mean{0, 0};
    for (const std::size_t v : loop) mean[0] += channel.mesh.points[v][0] / static_cast<double>(loop.size());
    for (const std::size_t v : loop) {
      const Vec3& p = channel.mesh.points[v];
      channel.add(mean[0] < 3 ? Numbers{p[0], p[1]} : turned(p[0], p[1]));
    }
  }
  const Far::Refinement refinement = refinedChannel(GetParam(), channel.mesh);
  const FaceVarying varying = builtVarying(refinement, channel);
  ASSERT_TRUE(varying.hasSeams());
  const std::vector<Numbers> values = levelValues(varying, channel);
  for (std::int32_t k = 1; k <= refinement.levelCount(); ++k) {
    const Far::Topology& topology = refinement.level(k).topology;
    const std::vector<Vec3> points = levelPoints<double>(refinement, k, channel.mesh.points);
    for (std::int32_t f = 0; f < topology.faceCount(); ++f) {
      double fromFirst = 0;
      double fromSecond = 0;
      for (std::int32_t h = at(topology.faceOffsets(), f); h < at(topology.faceOffsets(), f + 1); ++h) {
        const Numbers value = valueAt(varying.level(k), at(values, k), h, 2);
        const Vec3& p = at(points, topology.vert(h));
        const Numbers other = turned(p[0], p[1]);
        fromFirst = std::max(fromFirst, std::hypot(value[0] - p[0], value[1] - p[1]));
        fromSecond = std::max(fromSecond, std::hypot(value[0] - other[0], value[1] - other[1]));
      }
      ASSERT_LT(std::min(fromFirst, fromSecond), 1e-11) << "level " << k << " face " << f;
    }
  }
}

TEST_P(FaceVaryingBy, ColoursOfFacesStayWithinTheirCells) {
  Channel channel{cube(), {}, {}, 3};
  for (std::size_t f = 0; f < 6; ++f) {
    for (std::size_t i = 0; i < 4; ++i) channel.add({static_cast<double>(f), static_cast<double>(f % 2), 1});
  }
  const Far::Refinement refinement = refinedChannel(GetParam(), channel.mesh);
  const FaceVarying varying = builtVarying(refinement, channel);
  const Numbers values = levelValues(varying, channel).back();
  const Far::Topology& topology = refinement.last().topology;
  for (std::int32_t h = 0; h < topology.halfEdgeCount(); ++h) {
    const Numbers here = valueAt(varying.last(), values, h, 3);
    const Numbers next = valueAt(varying.last(), values, topology.next(h), 3);
    for (std::size_t i = 0; i < 3; ++i) ASSERT_NEAR(here[i], next[i], 1e-12);
    ASSERT_NEAR(here[0], std::round(here[0]), 1e-12);
  }
}

/// Along a crease a level is cut open, and grows together again when the crease was sharp for long enough. Wherever the
/// seam of a cylinder is, on a crease that stays or beside it, cells are as wide; on one that grows together or beside
/// it no cell is smeared.
TEST(FaceVarying, SeamsBesideAndOnCreasesAreContinued) {
  const Channel reference = mappedCylinder(8, 4, 2);
  Far::Polygons polygons = toPolygons(reference.mesh);
  for (const std::int32_t row : {0, 8, 16, 24}) {
    polygons.creases.push_back({row, row + 8, 1.5});
    polygons.creases.push_back({row + 4, row + 12, 10});
  }
  const auto control = Far::Topology::create(polygons);
  ASSERT_TRUE(control) << control.error().message;
  const auto refinement = Far::refine(*control, goldenChain("akleman", *control, kChannelLevels));
  ASSERT_TRUE(refinement) << refinement.error().message;
  const Far::Topology& topology = refinement->last().topology;
  const auto widths = [&](const Channel& channel) {
    const FaceVarying varying = builtVarying(*refinement, channel);
    const Numbers values = levelValues(varying, channel).back();
    Numbers result;
    for (std::int32_t h = 0; h < topology.halfEdgeCount(); ++h) {
      result.push_back(valueAt(varying.last(), values, topology.next(h), 2)[0] -
                       valueAt(varying.last(), values, h, 2)[0]);
    }
    return result;
  };
  const Numbers expected = widths(reference);
  EXPECT_LT(*std::max_element(expected.begin(), expected.end()), 0.2);
  for (const std::size_t seam : {3U, 4U, 5U}) {
    const Numbers found = widths(mappedCylinder(8, 4, seam));
    for (std::size_t h = 0; h < found.size(); ++h) ASSERT_NEAR(found[h], expected[h], 1e-12) << "seam " << seam;
  }
  for (const std::size_t seam : {0U, 1U, 7U}) {
    for (const double width : widths(mappedCylinder(8, 4, seam))) ASSERT_LT(std::abs(width), 0.2) << "seam " << seam;
  }
}

TEST(FaceVarying, ChartsWithoutAreaAreNotContinued) {
  Channel channel = separateCharts(cube(), 2);
  std::fill(channel.values.begin(), channel.values.begin() + 8, 0.25);  // all corners of face 0
  for (std::size_t i = 8; i < 16; i += 2) channel.values[i + 1] = 3;    // face 1 is a line
  const FaceVarying varying = builtVarying(refinedChannel("akleman", channel.mesh), channel);
  const Numbers values = levelValues(varying, channel).back();
  for (const double x : values) {
    EXPECT_GE(x, -2);
    EXPECT_LE(x, 53);
  }
}

std::string refusal(const Channel& channel) {
  const Far::Refinement refinement = refinedChannel("akleman", cube(), 1);
  const auto result = FaceVarying::build(refinement, {channel.length, channel.values, channel.corners});
  return result ? "" : result.error().message;
}

TEST(FaceVarying, RefusesWhatDoesNotFitTheMesh) {
  Channel channel = separateCharts(cube(), 2);
  channel.corners[6] = 24;
  EXPECT_EQ(refusal(channel),
            "corner 2 of face 1 (counted from 0) has the face-varying value 24 of 24; give every corner a value");
  channel.corners[6] = -1;
  EXPECT_EQ(refusal(channel),
            "corner 2 of face 1 (counted from 0) has the face-varying value -1 of 24; give every corner a value");
  channel.corners.resize(23);
  EXPECT_EQ(refusal(channel), "a face-varying channel names 23 corners, but the mesh has 24; give each corner a value");
  channel = separateCharts(cube(), 2);
  channel.values[7] = std::nan("");
  EXPECT_EQ(refusal(channel), "face-varying value 3 (counted from 0) holds nan; give finite numbers");
  channel.values.resize(47);
  EXPECT_EQ(refusal(channel), "47 numbers are no values of length 2; give whole values");
}

}  // namespace
}  // namespace honeycomb::Test
