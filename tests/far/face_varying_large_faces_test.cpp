#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "tests/far/channel.h"
#include "tests/support/shapes.h"
#include "tests/support/table_rows.h"

// Seams round faces of many sides.
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

/// One flat chart of all faces, and the same with those of 70 sides from `firstTurned` on turned, halved and moved:
/// seams beyond which all goes on alike. Central control vertices, which are at no corner, show at the second level.
void expectGoesOnInATurnedChart(const std::string& scheme, const PolyMesh& mesh, std::int32_t levels,
                                std::size_t firstTurned) {
  const auto turnedPoint = [](std::complex<double> z) { return std::complex(0.3, 0.4) * z + std::complex(2.0, 1.0); };
  Channel whole{mesh, {}, {}};
  Channel turned{mesh, {}, {}};
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (const std::size_t v : mesh.faces[f]) {
      const Vec3& p = mesh.points[v];
      const std::complex<double> z((2 + p[2]) * p[0], (2 + p[2]) * p[1]);
      const std::complex<double> w = mesh.faces[f].size() == 70 && f >= firstTurned ? turnedPoint(z) : z;
      whole.add({z.real(), z.imag()});
      turned.add({w.real(), w.imag()});
    }
  }
  const Far::Refinement refinement = refinedChannel(scheme, mesh, levels);
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
  ASSERT_NO_FATAL_FAILURE(expectGoesOnInATurnedChart(GetParam(), prism(70), 1, 0));
}

TEST(FaceVarying, SumsOfLargeFacesGoOnInAChartThatIsTurned) {
  ASSERT_NO_FATAL_FAILURE(expectGoesOnInATurnedChart("zhang-wang", pillow(70), 2, 1));
}

}  // namespace
}  // namespace honeycomb::Test
