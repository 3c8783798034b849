#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "tests/support/manifold_check.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

void checkHalfEdges(const Far::Topology& t) {
  for (std::int32_t h = 0; h < t.halfEdgeCount(); ++h) {
    ASSERT_EQ(t.next(t.prev(h)), h);
    ASSERT_EQ(t.prev(t.next(h)), h);
    ASSERT_EQ(t.face(t.next(h)), t.face(h));
    ASSERT_TRUE(t.vert(h) >= 0 && t.vert(h) < t.vertexCount()) << "half-edge " << h;
    const std::int32_t twin = t.twin(h);
    if (twin < 0) {
      ASSERT_EQ(twin, -1) << "half-edge " << h;
      continue;
    }
    ASSERT_NE(twin, h);
    ASSERT_EQ(t.twin(twin), h);
    ASSERT_EQ(t.vert(twin), t.dest(h)) << "half-edge " << h;
    ASSERT_EQ(t.dest(twin), t.vert(h)) << "half-edge " << h;
    ASSERT_NE(t.face(twin), t.face(h)) << "half-edge " << h;
  }
}

void checkRuns(const Far::Topology& t) {
  std::int32_t face = 0;
  std::int32_t halfEdge = 0;
  bool fullOver = false;
  for (const Far::FaceRun& run : t.runs()) {
    ASSERT_EQ(run.firstFace, face);
    ASSERT_EQ(run.firstHalfEdge, halfEdge);
    ASSERT_GT(run.faceCount, 0);
    ASSERT_GE(run.sides, 3);
    ASSERT_FALSE(fullOver && run.kind == Far::FaceKind::full) << "full faces come first";
    fullOver = run.kind != Far::FaceKind::full;
    for (std::int32_t f = face; f < face + run.faceCount; ++f) {
      ASSERT_EQ(t.sides(f), run.sides);
      for (std::int32_t i = 0; i < run.sides; ++i) ASSERT_EQ(t.face(at(t.faceOffsets(), f) + i), f);
    }
    face += run.faceCount;
    halfEdge += run.faceCount * run.sides;
  }
  ASSERT_EQ(face, t.faceCount());
  ASSERT_EQ(halfEdge, t.halfEdgeCount());
}

void checkVertices(const Far::Topology& t) {
  std::vector<std::int32_t> faces(static_cast<std::size_t>(t.vertexCount()), 0);
  std::vector<bool> border(faces.size(), false);
  for (std::int32_t h = 0; h < t.halfEdgeCount(); ++h) {
    ++at(faces, t.vert(h));
    if (t.twin(h) < 0) border[static_cast<std::size_t>(t.vert(h))] = true;
  }
  for (std::int32_t v = 0; v < t.vertexCount(); ++v) {
    const bool onBorder = border[static_cast<std::size_t>(v)];
    ASSERT_EQ(t.vert(t.outgoing(v)), v);
    ASSERT_EQ(t.onBoundary(v), onBorder) << "vertex " << v;
    ASSERT_EQ(t.twin(t.outgoing(v)) < 0, onBorder) << "vertex " << v << " names a boundary half-edge where it has one";
    ASSERT_EQ(t.facesAt(v), at(faces, v)) << "vertex " << v;
    ASSERT_EQ(t.valence(v), at(faces, v) + (onBorder ? 1 : 0)) << "vertex " << v;
  }
}

void checkBoundary(const Far::Topology& t) {
  std::vector<std::int32_t> expected;
  for (std::int32_t h = 0; h < t.halfEdgeCount(); ++h) {
    if (t.twin(h) < 0) expected.push_back(h);
  }
  ASSERT_EQ(std::vector<std::int32_t>(t.boundary().begin(), t.boundary().end()), expected);
  ASSERT_EQ(t.boundaryTags().size(), expected.size());
  ASSERT_EQ(t.closed(), expected.empty());
  const auto ranks = Far::boundaryRanks(t);
  ASSERT_EQ(ranks.size(), expected.empty() ? 0U : static_cast<std::size_t>(t.halfEdgeCount()));
  for (std::size_t r = 0; r < expected.size(); ++r) ASSERT_EQ(at(ranks, expected[r]), static_cast<std::int32_t>(r));
}

/// Cuts and mid-points go together: a face of kind half has one cut, one of kind corner two half cuts, others none.
void checkTags(const Far::Topology& t) {
  std::vector<int> cuts(static_cast<std::size_t>(t.faceCount()), 0);
  std::vector<int> halfCuts(cuts.size(), 0);
  for (std::size_t r = 0; r < t.boundary().size(); ++r) {
    const std::int32_t h = t.boundary()[r];
    const Far::EdgeTag tag = t.boundaryTags()[r];
    if (tag == Far::EdgeTag::cut) ++at(cuts, t.face(h));
    if (tag == Far::EdgeTag::cutToCorner) ++at(halfCuts, t.face(h));
    const int fixedEnds = (t.vertexTag(t.vert(h)) == Far::VertexTag::fixedCorner ? 1 : 0) +
                          (t.vertexTag(t.dest(h)) == Far::VertexTag::fixedCorner ? 1 : 0);
    ASSERT_EQ(fixedEnds, tag == Far::EdgeTag::cutToCorner ? 1 : 0) << "boundary half-edge " << h;
  }
  for (const Far::FaceRun& run : t.runs()) {
    for (std::int32_t f = run.firstFace; f < run.firstFace + run.faceCount; ++f) {
      ASSERT_EQ(at(cuts, f), run.kind == Far::FaceKind::half ? 1 : 0) << "face " << f;
      ASSERT_EQ(at(halfCuts, f), run.kind == Far::FaceKind::corner ? 2 : 0) << "face " << f;
    }
  }
}

void checkTopology(const Far::Topology& t) {
  ASSERT_NO_FATAL_FAILURE(checkHalfEdges(t));
  ASSERT_NO_FATAL_FAILURE(checkRuns(t));
  ASSERT_NO_FATAL_FAILURE(checkVertices(t));
  ASSERT_NO_FATAL_FAILURE(checkBoundary(t));
  ASSERT_NO_FATAL_FAILURE(checkTags(t));
}

TEST(RandomMeshes, AreManifoldAndVaried) {
  std::set<std::size_t> sides;
  std::set<std::int64_t> characteristics;
  std::size_t valenceTwo = 0;
  std::size_t tags = 0;
  for (std::uint64_t seed = 0; seed < meshes(400); ++seed) {
    const RandomMesh random = randomMesh(seed);
    std::string why;
    ASSERT_TRUE(isManifold(random.mesh.faces, &why)) << "seed " << seed << ": " << why;
    ASSERT_EQ(boundaryEdgeCount(random.mesh.faces) == 0, borderOf(seed) == Border::closed) << "seed " << seed;
    std::vector<int> faces(random.mesh.points.size(), 0);
    for (const Loop& loop : random.mesh.faces) {
      sides.insert(loop.size());
      for (const std::size_t v : loop) ++faces[v];
    }
    if (borderOf(seed) == Border::closed) {
      characteristics.insert(eulerCharacteristic(random.mesh.faces));
      valenceTwo += static_cast<std::size_t>(std::count(faces.begin(), faces.end(), 2));
    }
    tags += random.cornerTags.size();
  }
  EXPECT_GE(sides.size(), 20U);
  EXPECT_GE(*sides.rbegin(), 50U);
  EXPECT_GE(characteristics.size(), 5U) << "spheres, several components, and genus above 0";
  EXPECT_LE(*characteristics.begin(), -4) << "genus 3";
  EXPECT_GE(valenceTwo, 50U);
  EXPECT_GE(tags, 50U);
}

TEST(Topology, KeepsTheCallersLoopsSortedStablyBySides) {
  for (std::uint64_t seed = 0; seed < meshes(200); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const RandomMesh random = randomMesh(seed);
    const Far::Topology t = toTopology(random.mesh, random.cornerTags);
    ASSERT_EQ(t.vertexCount(), static_cast<std::int32_t>(random.mesh.points.size()));
    ASSERT_EQ(t.faceCount(), static_cast<std::int32_t>(random.mesh.faces.size()));
    const PolyMesh stored = toMesh(t, random.mesh.points);
    for (std::int32_t f = 0; f < t.faceCount(); ++f) {
      ASSERT_EQ(at(stored.faces, f), at(random.mesh.faces, t.inputFace(f)));
      if (f == 0 || t.sides(f - 1) != t.sides(f)) continue;
      ASSERT_LT(t.inputFace(f - 1), t.inputFace(f)) << "equal side counts keep the caller's order";
    }
    for (const std::size_t v : random.cornerTags) {
      ASSERT_EQ(t.vertexTag(static_cast<std::int32_t>(v)), Far::VertexTag::corner);
    }
  }
}

TEST(Topology, HoldsItsInvariantsAtLevelZero) {
  for (std::uint64_t seed = 0; seed < meshes(200); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const RandomMesh random = randomMesh(seed);
    ASSERT_NO_FATAL_FAILURE(checkTopology(toTopology(random.mesh, random.cornerTags)));
  }
}

TEST(Topology, HoldsItsInvariantsAtEveryLevelUnderEveryBoundaryRule) {
  for (const auto boundary : {ReferenceBoundary::brick, ReferenceBoundary::eq16, ReferenceBoundary::drop}) {
    const SchemeCase scheme = schemeCase(NamedTension::paper, boundary);
    for (std::uint64_t seed = 0; seed < meshes(200); ++seed) {
      SCOPED_TRACE(scheme.name + ", seed " + std::to_string(seed));
      const RandomMesh random = randomMesh(seed);
      const auto reference = referenceLevel(random.mesh, {}, scheme.reference, 1);
      if (reference.mesh.faces.empty()) continue;  // `drop` leaves nothing of it
      const std::int32_t levels = boundary == ReferenceBoundary::drop ? 1 : 3;
      const Far::Refinement refinement = refined(random, scheme.scheme, levels);
      for (std::int32_t k = 1; k <= levels; ++k) {
        ASSERT_NO_FATAL_FAILURE(checkTopology(refinement.level(k).topology)) << "level " << k;
      }
    }
  }
}

TEST(Topology, NumbersCornerPointsLikeTheirHalfEdges) {
  for (std::uint64_t seed = 0; seed < meshes(200); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Far::Refinement refinement = refined(randomMesh(seed), schemeCase(NamedTension::paper).scheme, 1);
    const Far::Topology& control = refinement.level(0).topology;
    const Far::Topology& t = refinement.level(1).topology;
    for (const Far::FaceRun& run : t.runs()) {
      if (run.parent != Far::FaceParent::face || run.kind != Far::FaceKind::full) continue;
      for (std::int32_t h = run.firstHalfEdge; h < run.firstHalfEdge + run.sides * run.faceCount; ++h) {
        ASSERT_EQ(t.vert(h), h);
        if (control.closed()) {
          ASSERT_EQ(t.face(h), control.face(h)) << "face-faces keep their place";
        }
      }
    }
  }
}

}  // namespace
}  // namespace honeycomb::Test
