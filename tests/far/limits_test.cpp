#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/golden.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

constexpr double kNoise = 1e-13;

/// The face of level `to` that face f of level `from` becomes, step by step.
std::int32_t descendant(const Far::Refinement& refinement, std::int32_t from, std::int32_t f, std::int32_t to) {
  for (std::int32_t k = from + 1; k <= to; ++k) {
    const Far::Topology& t = refinement.level(k).topology;
    std::int32_t child = -1;
    for (const Far::FaceRun& run : t.runs()) {
      if (run.parent != Far::FaceParent::face) continue;
      const auto first = t.parents().begin() + run.firstFace;
      const auto found = std::find(first, first + run.faceCount, f);
      if (found != first + run.faceCount) child = static_cast<std::int32_t>(found - t.parents().begin());
    }
    f = child;
  }
  return f;
}

/// The face of level k that vertex v of level k-1 becomes, or -1.
std::int32_t vertexFace(const Far::Refinement& refinement, std::int32_t k, std::int32_t v) {
  const Far::Topology& t = refinement.level(k).topology;
  for (const Far::FaceRun& run : t.runs()) {
    if (run.parent != Far::FaceParent::vertex) continue;
    for (std::int32_t f = run.firstFace; f < run.firstFace + run.faceCount; ++f) {
      if (at(t.parents(), f) == v) return f;
    }
  }
  return -1;
}

/// Twice the vector area of a polygon.
Vec3 areaNormal(const std::vector<Vec3>& polygon) {
  Vec3 sum{};
  const Vec3 middle = centroid(polygon);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    sum = sum + cross(polygon[i] - middle, polygon[(i + 1) % polygon.size()] - middle);
  }
  return sum;
}

double angleBetween(const Vec3& a, const Vec3& b) {
  return std::atan2(length(cross(a, b)), dot(a, b));
}

/// Face and vertex limits of level 1 against the mesh seven levels on.
void compareWithConvergedMesh(const PolyMesh& control, const SchemeCase& scheme, const std::vector<std::size_t>& tags,
                              double largestAngle) {
  constexpr std::int32_t kDeep = 8;
  const Far::Refinement deep = refined(control, scheme.scheme, kDeep, tags);
  const Far::Refinement first = refined(control, scheme.scheme, 1, tags, true);
  const PolyMesh mesh = levelMesh(first, 1, control.points);
  const PolyMesh converged = levelMesh(deep, kDeep, control.points);
  const Limits faces = faceLimits<double>(first, mesh.points);
  const Limits vertices = vertexLimits<double>(first, mesh.points);
  const Far::Topology& t = first.last().topology;

  const auto compare = [&](std::int32_t deepFace, const Vec3& position, const Vec3& normal, const std::string& what) {
    const auto polygon = corners(converged, static_cast<std::size_t>(deepFace));
    double radius = 0;
    for (const Vec3& p : polygon) radius = std::max(radius, distance(p, position));
    ASSERT_LT(radius, 0.1) << what << " hasn't converged to its limit position";
    ASSERT_NEAR(length(normal), 1, 1e-12) << what;
    ASSERT_LT(angleBetween(normal, areaNormal(polygon)), largestAngle) << what;
  };
  for (std::int32_t f = 0; f < t.faceCount(); f += 1 + t.faceCount() / 60) {
    ASSERT_NO_FATAL_FAILURE(compare(descendant(deep, 1, f, kDeep), at(faces.positions, f), at(faces.normals, f),
                                    "face " + std::to_string(f)));
  }
  for (std::int32_t v = 0; v < t.vertexCount(); v += 1 + t.vertexCount() / 60) {
    const std::int32_t child = vertexFace(deep, 2, v);
    if (child < 0) continue;
    ASSERT_NO_FATAL_FAILURE(compare(descendant(deep, 2, child, kDeep), at(vertices.positions, v),
                                    at(vertices.normals, v), "vertex " + std::to_string(v)));
  }
}

TEST(Limits, AreWhereTheClosedMeshConverges) {
  for (const char* shape : {"cube", "dodecahedron", "torus"}) {
    SCOPED_TRACE(shape);
    const PolyMesh mesh = readGoldenMesh(std::string(shape) + ".obj");
    ASSERT_NO_FATAL_FAILURE(compareWithConvergedMesh(mesh, schemeCase(NamedTension::paper), {}, 0.06));
    ASSERT_NO_FATAL_FAILURE(compareWithConvergedMesh(mesh, schemeCase(NamedTension::sqrt3), {}, 0.06));
  }
}

TEST(Limits, AreWhereTheOpenMeshConverges) {
  for (const char* shape : {"grid", "honeycomb"}) {
    SCOPED_TRACE(shape);
    ASSERT_NO_FATAL_FAILURE(compareWithConvergedMesh(readGoldenMesh(std::string(shape) + ".obj"),
                                                     schemeCase(NamedTension::paper), {}, 0.1));
  }
}

TEST(Limits, OfFacesStayUnderRefinement) {
  // A face's limit is that of its face-face, whatever the boundary did to it.
  for (std::uint64_t seed = 0; seed < meshes(100); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const RandomMesh random = randomMesh(seed);
    const Far::Scheme scheme = schemeCase(NamedTension::paper).scheme;
    const Far::Refinement coarse = refined(random, scheme, 1, true);
    const Far::Refinement fine = refined(random, scheme, 2, true);
    const Limits before = faceLimits<double>(coarse, levelPoints<double>(coarse, 1, random.mesh.points));
    const Limits after = faceLimits<double>(fine, levelPoints<double>(fine, 2, random.mesh.points));
    const Far::Topology& t = fine.last().topology;
    for (const Far::FaceRun& run : t.runs()) {
      if (run.parent != Far::FaceParent::face) continue;
      for (std::int32_t f = run.firstFace; f < run.firstFace + run.faceCount; ++f) {
        const std::int32_t parent = at(t.parents(), f);
        ASSERT_LT(distance(at(before.positions, parent), at(after.positions, f)), kNoise)
            << "face " << f << " of kind " << static_cast<int>(run.kind);
      }
    }
  }
}

TEST(Limits, OfVerticesAreThoseOfTheFacesTheyBecome) {
  for (const auto boundary : {ReferenceBoundary::brick, ReferenceBoundary::eq16}) {
    const SchemeCase scheme = schemeCase(NamedTension::paper, boundary);
    for (std::uint64_t seed = 0; seed < meshes(60); ++seed) {
      SCOPED_TRACE(scheme.name + ", seed " + std::to_string(seed));
      const RandomMesh random = randomMesh(seed);
      const Far::Refinement coarse = refined(random, scheme.scheme, 1, true);
      const Far::Refinement fine = refined(random, scheme.scheme, 2, true);
      const Limits vertices = vertexLimits<double>(coarse, levelPoints<double>(coarse, 1, random.mesh.points));
      const Limits faces = faceLimits<double>(fine, levelPoints<double>(fine, 2, random.mesh.points));
      const Far::Topology& t = fine.last().topology;
      for (const Far::FaceRun& run : t.runs()) {
        if (run.parent != Far::FaceParent::vertex) continue;
        for (std::int32_t f = run.firstFace; f < run.firstFace + run.faceCount; ++f) {
          const std::int32_t v = at(t.parents(), f);
          ASSERT_LT(distance(at(vertices.positions, v), at(faces.positions, f)), kNoise) << "vertex " << v;
          ASSERT_LT(distance(at(vertices.normals, v), at(faces.normals, f)), 1e-9) << "vertex " << v;
        }
      }
    }
  }
}

/// 1/(2n) sum over the faces f at v, sum_k (c_k + c_{k+1}) p_{f,k} with p_{f,0} = v and p_{f,k} counter-clockwise: the
/// mean of the points that the edges leaving and entering v get.
std::vector<Vec3> closedFormLimits(const PolyMesh& mesh, double tension, double t) {
  std::vector<Vec3> sums(mesh.points.size());
  std::vector<int> valence(mesh.points.size(), 0);
  for (const Loop& loop : mesh.faces) {
    const std::size_t n = loop.size();
    const auto c = closedFormula(tension, t, n);
    for (std::size_t i = 0; i < n; ++i) {
      ++valence[loop[i]];
      for (std::size_t k = 0; k < n; ++k) {
        sums[loop[i]] = sums[loop[i]] + (c[k] + c[(k + 1) % n]) * mesh.points[loop[(i + k) % n]];
      }
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v) sums[v] = (1.0 / (2 * valence[v])) * sums[v];
  return sums;
}

TEST(Limits, OfVerticesFollowTheClosedForm) {
  for (const double t : {0.5, 0.2}) {
    const SchemeCase scheme = schemeCase(0.6, ReferenceBoundary::brick, t);
    for (std::uint64_t seed = 0; seed < meshes(60); ++seed) {
      const RandomMesh random = randomMesh(seed, Border::closed);
      const Far::Refinement refinement = refined(random, scheme.scheme, 1, true);
      const PolyMesh mesh = levelMesh(refinement, 1, random.mesh.points);
      const Limits limits = vertexLimits<double>(refinement, mesh.points);
      const auto expected = closedFormLimits(mesh, 0.6, t);
      for (std::size_t v = 0; v < expected.size(); ++v) {
        ASSERT_LT(distance(limits.positions[v], expected[v]), kNoise)
            << "seed " << seed << ", t " << t << ", vertex " << v;
      }
    }
  }
}

/// The boundary vertices before and after boundary vertex v.
std::pair<std::int32_t, std::int32_t> boundaryNeighbours(const Far::Topology& t, std::int32_t v) {
  std::int32_t before = -1;
  for (const std::int32_t h : t.boundary()) {
    if (t.dest(h) == v) before = t.vert(h);
  }
  return {before, t.dest(t.outgoing(v))};
}

TEST(Limits, OfBrickMidPointsLieOnTheBoundaryCurve) {
  // Two steps take a mid-point m to (m_- + 10 m + m_+)/12; its limit is (m_- + 8 m + m_+)/10, tangent m_+ - m_-.
  for (std::uint64_t seed = 1; seed < meshes(120); seed += 2) {
    const RandomMesh random = randomMesh(seed);
    for (const std::int32_t level : {1, 3}) {
      const Far::Refinement refinement = refined(random.mesh, schemeCase(NamedTension::paper).scheme, level, {}, true);
      const auto points = levelPoints<double>(refinement, level, random.mesh.points);
      const Limits limits = vertexLimits<double>(refinement, points);
      const Far::Topology& t = refinement.last().topology;
      int found = 0;
      for (std::int32_t v = 0; v < t.vertexCount(); ++v) {
        if (t.vertexTag(v) != Far::VertexTag::mid) continue;
        ++found;
        const auto [before, after] = boundaryNeighbours(t, v);
        const Vec3 expected = 0.1 * (at(points, before) + 8 * at(points, v) + at(points, after));
        ASSERT_LT(distance(at(limits.positions, v), expected), kNoise) << "seed " << seed << ", level " << level;
        const Vec3 tangent = unit(at(points, after) - at(points, before));
        ASSERT_LT(std::abs(dot(at(limits.normals, v), tangent)), 1e-7) << "the normal leans along the boundary";
      }
      ASSERT_GT(found, 0);
    }
  }
}

TEST(Limits, OfFixedCornersAreTheCornersThemselves) {
  std::uint64_t found = 0;
  for (std::uint64_t seed = 1; seed < meshes(120); seed += 2) {
    const RandomMesh random = randomMesh(seed);
    const Far::Refinement refinement = refined(random, schemeCase(NamedTension::paper).scheme, 2, true);
    const auto points = levelPoints<double>(refinement, 2, random.mesh.points);
    const Limits limits = vertexLimits<double>(refinement, points);
    const Far::Topology& t = refinement.last().topology;
    for (std::int32_t v = 0; v < t.vertexCount(); ++v) {
      if (t.vertexTag(v) != Far::VertexTag::fixedCorner) continue;
      ++found;
      EXPECT_EQ(at(limits.positions, v), at(points, v)) << "seed " << seed;
    }
  }
  EXPECT_GT(found, meshes(120) / 2);
}

TEST(Limits, AreFiniteForEveryVertexUnderEveryBoundaryRule) {
  for (const auto boundary : {ReferenceBoundary::brick, ReferenceBoundary::eq16, ReferenceBoundary::drop}) {
    const SchemeCase scheme = schemeCase(NamedTension::paper, boundary);
    for (const char* shape : {"grid", "honeycomb"}) {
      const PolyMesh control = readGoldenMesh(std::string(shape) + ".obj");
      const Far::Refinement refinement = refined(control, scheme.scheme, 2, {}, true);
      const Limits limits = vertexLimits<double>(refinement, levelPoints<double>(refinement, 2, control.points));
      for (std::size_t v = 0; v < limits.positions.size(); ++v) {
        ASSERT_NEAR(length(limits.normals[v]), 1, 1e-12) << scheme.name << ", vertex " << v;
        ASSERT_TRUE(std::isfinite(dot(limits.positions[v], {1, 1, 1}))) << scheme.name << ", vertex " << v;
        // The mesh is a height field: every normal points up, and no limit strays from its mesh.
        EXPECT_GT(limits.normals[v][2], 0) << scheme.name << ", " << shape << ", vertex " << v;
      }
    }
  }
}

TEST(Limits, InFloatAreThoseInDoubleRounded) {
  const PolyMesh control = readGoldenMesh("mixed.obj");
  const Far::Refinement refinement = refined(control, schemeCase(NamedTension::paper).scheme, 2, {}, true);
  const auto points = levelPoints<double>(refinement, 2, control.points);
  const Limits exact = vertexLimits<double>(refinement, points);
  const Limits single = vertexLimits<float>(refinement, points);
  for (std::size_t v = 0; v < points.size(); ++v) {
    EXPECT_LT(distance(exact.positions[v], single.positions[v]), 1e-5);
    EXPECT_LT(distance(exact.normals[v], single.normals[v]), 1e-3);
  }
}

TEST(Limits, SpanTheTangentPlanesOfFacesWhateverTheirNumberOfSides) {
  const Far::Refinement refinement = refined(torus(6, 5), schemeCase(NamedTension::paper).scheme, 2, {}, true);
  const Far::LimitRows& rows = refinement.limits().faces;
  const std::vector<Vec3> points{{2, 0, 0.5},   {1, 1, 0},   {0, 2, 1},    {-1, 1, 0},
                                 {-2, 0, 0.25}, {-1, -1, 0}, {0, -2, 0.5}, {1, -1, 1}};
  std::vector<std::int32_t> sides;
  for (const Far::FrameBatch& batch : rows.batches) {
    sides.push_back(batch.sides);
    const std::vector<Vec3> polygon(points.begin(), points.begin() + batch.sides);
    const auto sum = [&](std::int32_t row) {
      Vec3 total{0, 0, 0};
      for (std::size_t j = 0; j < polygon.size(); ++j) {
        const auto first = static_cast<std::size_t>(batch.firstWeight + row * batch.sides);
        total = total + rows.weights[first + j] * polygon[j];
      }
      return total;
    };
    EXPECT_LT(distance(unit(cross(sum(1), sum(2))), unit(tangentNormal(polygon))), 1e-14) << batch.sides << " sides";
  }
  std::sort(sides.begin(), sides.end());
  EXPECT_EQ(sides, (std::vector<std::int32_t>{4, 6, 8}));
}

TEST(Limits, ADegenerateFaceHasTheZeroNormal) {
  PolyMesh control = tetrahedron();
  for (Vec3& p : control.points) p = {0, 0, 0};
  const Far::Refinement refinement = refined(control, schemeCase(NamedTension::paper).scheme, 1, {}, true);
  const Limits limits = faceLimits<double>(refinement, levelPoints<double>(refinement, 1, control.points));
  for (const Vec3& n : limits.normals) EXPECT_EQ(n, (Vec3{0, 0, 0}));
}

}  // namespace
}  // namespace honeycomb::Test
