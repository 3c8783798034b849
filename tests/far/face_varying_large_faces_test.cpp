#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "far/schemes/akleman.h"
#include "far/schemes/zhang_wang.h"
#include "tests/far/channel.h"
#include "tests/support/creased.h"
#include "tests/support/shapes.h"
#include "tests/support/table_rows.h"

// Seams round faces of many sides and vertices of many faces, with creases and without.
namespace honeycomb::Test {
namespace {

using Far::FaceVarying;

/// A prism of n sides whose every face is a chart of its own: caps round, sides of an edge's length.
Channel chartedPrism(std::size_t n) {
  Channel channel{prism(n), {}, {}};
  const double step = 2 * std::numbers::pi / static_cast<double>(n);
  for (const Loop& loop : channel.mesh.faces) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const double angle = step * static_cast<double>(i);
      const double edge = step * static_cast<double>((0b0110U >> i) & 1U);
      loop.size() == n ? channel.add({std::cos(angle), std::sin(angle)})
                       : channel.add({edge, step * static_cast<double>(i / 2)});
    }
  }
  return channel;
}

TEST_P(FaceVaryingBy, LargeFacesThatAreChartsHaveTablesOfLinearSize) {
  std::vector<double> bytes;
  for (const std::size_t n : {100U, 400U}) {
    for (const std::int32_t length : {2, 1}) {
      // The same numbers in pairs, which are continued, and one by one, which aren't.
      Channel channel = chartedPrism(n);
      if (length == 1) {
        channel.length = 1;
        for (std::int32_t& corner : channel.corners) corner *= 2;
      }
      bytes.push_back(
          static_cast<double>(builtVarying(refinedChannel(GetParam(), channel.mesh, 2), channel).byteCount()));
    }
  }
  EXPECT_LT(bytes[2], 4.2 * bytes[0]);
  EXPECT_LT(bytes[3], 4.2 * bytes[1]);
}

/// One flat chart of all faces, and the same with those from `firstTurned` on, of that many sides, turned, halved and
/// moved: seams beyond which all goes on alike. Central control vertices, which are at no corner, show at the second
/// level.
void expectGoesOnInATurnedChart(const Far::Refinement& refinement, const PolyMesh& mesh, std::size_t sides,
                                std::size_t firstTurned) {
  const auto turnedPoint = [](std::complex<double> z) { return std::complex(0.3, 0.4) * z + std::complex(2.0, 1.0); };
  Channel whole{mesh, {}, {}};
  Channel turned{mesh, {}, {}};
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (const std::size_t v : mesh.faces[f]) {
      const Vec3& p = mesh.points[v];
      const std::complex<double> z((2 + p[2]) * p[0], (2 + p[2]) * p[1]);
      const std::complex<double> w = mesh.faces[f].size() == sides && f >= firstTurned ? turnedPoint(z) : z;
      whole.add({z.real(), z.imag()});
      turned.add({w.real(), w.imag()});
    }
  }
  const std::int32_t levels = refinement.levelCount();
  const FaceVarying expected = builtVarying(refinement, whole);
  const FaceVarying actual = builtVarying(refinement, turned);
  Numbers inOne = whole.values;
  Numbers inTwo = turned.values;
  for (std::int32_t k = 1; k <= levels; ++k) {
    inOne = evaluateChannel(expected.level(k).table, inOne, 2);
    inTwo = evaluateChannel(actual.level(k).table, inTwo, 2);
  }
  const auto valueAt = [levels](const FaceVarying& varying, const Numbers& values, std::int32_t h) {
    const auto i = 2 * static_cast<std::size_t>(at(varying.level(levels).corners, h));
    return std::complex(values[i], values[i + 1]);
  };
  for (std::int32_t h = 0; h < refinement.level(levels).topology.halfEdgeCount(); ++h) {
    const std::complex<double> z = valueAt(expected, inOne, h);
    const std::complex<double> w = valueAt(actual, inTwo, h);
    ASSERT_LT(std::min(std::abs(w - z), std::abs(w - turnedPoint(z))), 1e-9) << "half-edge " << h;
  }
}

TEST_P(FaceVaryingBy, LargeFacesGoOnInAChartThatIsTurned) {
  const PolyMesh mesh = prism(70);
  ASSERT_NO_FATAL_FAILURE(expectGoesOnInATurnedChart(refinedChannel(GetParam(), mesh, 1), mesh, 70, 0));
}

/// n triangles round a vertex above and as many below.
PolyMesh bipyramid(std::size_t n) {
  PolyMesh mesh = wheel(n);
  mesh.points.push_back({0, 0, -1});
  for (std::size_t f = 0; f < n; ++f) {
    const Loop loop = mesh.faces[f];
    mesh.faces.push_back({loop[0] == 0 ? n + 1 : loop[0], loop[2], loop[1]});
  }
  return mesh;
}

TEST(FaceVarying, LargeVerticesGoOnInAChartThatIsTurned) {
  const PolyMesh mesh = bipyramid(70);
  for (const char* scheme : {"akleman", "zhang-wang", "doo-sabin", "midpoint", "trisect", "centroid"}) {
    SCOPED_TRACE(scheme);
    ASSERT_NO_FATAL_FAILURE(expectGoesOnInATurnedChart(refinedChannel(scheme, mesh, 1), mesh, 3, 30));
  }
}

std::vector<Far::Scheme> aklemanSteps(std::size_t levels) {
  return {levels, *Far::akleman({})};
}

TEST(FaceVarying, LargeFacesAtWhichCreasesEndGoOnInAChartThatIsTurned) {
  for (const double sharpness : {0.5, 1.5, 10.0}) {
    SCOPED_TRACE(sharpness);
    const CreasedMesh posts = meetingCreases(70, sharpness).front();
    const Far::Refinement refinement = refinedBy(creased(posts.mesh, posts.creases), aklemanSteps(2));
    ASSERT_NO_FATAL_FAILURE(expectGoesOnInATurnedChart(refinement, posts.mesh, 70, 0));
  }
}

TEST(FaceVarying, LargeVerticesInWhichACreaseEndsGoOnInAChartThatIsTurned) {
  const PolyMesh mesh = wheel(70);
  for (const double sharpness : {0.5, 10.0}) {
    SCOPED_TRACE(sharpness);
    const Far::Refinement refinement = refinedBy(creased(mesh, {{0, 1, sharpness}}), aklemanSteps(2));
    ASSERT_NO_FATAL_FAILURE(expectGoesOnInATurnedChart(refinement, mesh, 3, 30));
  }
}

/// A crease from rim to rim of a wheel and of a bipyramid, and one that ends at its apex.
std::vector<CreasedMesh> creasesThroughAVertex(std::size_t n, double sharpness) {
  const auto far = static_cast<std::int32_t>(1 + n / 2);
  std::vector<CreasedMesh> meshes;
  for (const PolyMesh& mesh : {wheel(n), bipyramid(n)}) {
    const std::string sides = std::to_string(n) + " sides, " + std::to_string(mesh.faces.size()) + " faces";
    meshes.push_back({"through, " + sides, mesh, {{1, 0, sharpness}, {0, far, sharpness}}});
    meshes.push_back({"into, " + sides, mesh, {{1, 0, sharpness}}});
  }
  return meshes;
}

/// What grows together behind them is seen over another part of it. Few sides are read point by point, many by sums.
TEST(FaceVarying, WhatGrewTogetherThroughAVertexGoesOnInAChartThatIsTurned) {
  for (const std::size_t n : {8U, 64U, 70U}) {
    for (const double sharpness : {1.0, 1.5}) {
      for (const CreasedMesh& c : creasesThroughAVertex(n, sharpness)) {
        SCOPED_TRACE(c.name + ", sharpness " + std::to_string(sharpness));
        const Far::Topology control = creased(c.mesh, c.creases);
        Far::ZhangWangOptions options;
        options.boundary = Far::BoundaryRule::brick;
        options.unchecked = true;
        for (const auto& chain : {aklemanSteps(3), *Far::zhangWang(control, 3, options)}) {
          ASSERT_NO_FATAL_FAILURE(expectGoesOnInATurnedChart(refinedBy(control, chain), c.mesh, 3, n / 3));
        }
      }
    }
  }
}

/// A channel of one chart, but for the first face, and one whose every face is a chart of its own.
std::vector<Channel> seamedChannels(const PolyMesh& mesh) {
  Channel one{mesh, {}, {}};
  Channel all{mesh, {}, {}};
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (const std::size_t v : mesh.faces[f]) {
      const Vec3& p = mesh.points[v];
      one.add({(2 + p[2]) * p[0] + (f == 0 ? 9 : 0), (2 + p[2]) * p[1]});
      all.add({(2 + p[2]) * p[0] + 9.0 * static_cast<double>(f), (2 + p[2]) * p[1]});
    }
  }
  return {one, all};
}

/// Creases that end at large faces and vertices, one through a vertex, and one that ends there.
std::vector<CreasedMesh> seamedCreases(std::size_t n, double sharpness) {
  std::vector<CreasedMesh> meshes = meetingCreases(n, sharpness);
  const auto far = static_cast<std::int32_t>(1 + n / 2);
  meshes.push_back({"through a wheel", wheel(n), {{1, 0, sharpness}, {0, far, sharpness}}});
  meshes.push_back({"into a wheel", wheel(n), {{1, 0, sharpness}}});
  return meshes;
}

std::vector<std::int64_t> bytesWithSeamsAndCreases(std::size_t n, double sharpness) {
  std::vector<std::int64_t> bytes;
  for (const CreasedMesh& c : seamedCreases(n, sharpness)) {
    const Far::Refinement refinement = refinedBy(creased(c.mesh, c.creases), aklemanSteps(2));
    for (const Channel& channel : seamedChannels(c.mesh)) {
      bytes.push_back(builtVarying(refinement, channel).byteCount());
    }
  }
  return bytes;
}

TEST(FaceVarying, LargeFacesWithCreasesAndSeamsHaveTablesOfLinearSize) {
  for (const double sharpness : {0.5, 1.5, 10.0}) {
    const std::vector<std::int64_t> small = bytesWithSeamsAndCreases(100, sharpness);
    const std::vector<std::int64_t> large = bytesWithSeamsAndCreases(400, sharpness);
    ASSERT_EQ(small.size(), large.size());
    for (std::size_t i = 0; i < small.size(); ++i) {
      EXPECT_LT(large[i], 4.2 * static_cast<double>(small[i])) << "sharpness " << sharpness << ", case " << i;
    }
  }
}

TEST(FaceVarying, SumsOfLargeFacesGoOnInAChartThatIsTurned) {
  const PolyMesh mesh = pillow(70);
  ASSERT_NO_FATAL_FAILURE(expectGoesOnInATurnedChart(refinedChannel("zhang-wang", mesh, 2), mesh, 70, 1));
}

}  // namespace
}  // namespace honeycomb::Test
