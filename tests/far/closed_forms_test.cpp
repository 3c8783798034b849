#include "far/topology/splits/closed_forms.h"

#include <gtest/gtest.h>

#include <span>
#include <string>
#include <vector>

#include "far/topology/splits/zip_rules.h"
#include "tests/support/random_mesh.h"
#include "tests/support/refined.h"
#include "tests/support/scheme_list.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

using Form = Far::SplitResult (*)(const Far::Topology&);

/// A split in closed form and by its slots.
struct Forms {
  std::string name;
  Form closed;
  Form slots;
  bool threeEdges = false;  // inside vertices need three edges
};
const Forms kForms[] = {{"zip", Far::zipClosed, Far::zipDrop},
                        {"chamfer", Far::chamferClosed, Far::chamferBySlots},
                        {"expand", Far::expandClosed, Far::expandBySlots, true},
                        {"ambo", Far::amboClosed, Far::amboBySlots, true},
                        {"truncate", Far::truncateClosed, Far::truncateBySlots, true},
                        {"dual", Far::dualClosed, Far::dualBySlots, true}};

template <class T>
std::vector<T> copy(std::span<const T> values) {
  return {values.begin(), values.end()};
}

void expectSame(const Far::SplitResult& a, const Far::SplitResult& b) {
  EXPECT_EQ(copy(a.topology.runs()), copy(b.topology.runs()));
  EXPECT_EQ(copy(a.topology.vert()), copy(b.topology.vert()));
  EXPECT_EQ(copy(a.topology.twin()), copy(b.topology.twin()));
  EXPECT_EQ(copy(a.topology.face()), copy(b.topology.face()));
  EXPECT_EQ(copy(a.topology.faceOffsets()), copy(b.topology.faceOffsets()));
  EXPECT_EQ(copy(a.topology.outgoing()), copy(b.topology.outgoing()));
  EXPECT_EQ(copy(a.topology.parents()), copy(b.topology.parents()));
  EXPECT_EQ(a.topology.vertexCount(), b.topology.vertexCount());
  EXPECT_EQ(a.topology.threeValent(), b.topology.threeValent());
  EXPECT_EQ(a.topology.closed(), b.topology.closed());
  EXPECT_EQ(a.cornerPoints, b.cornerPoints);
  ASSERT_EQ(a.otherPoints.size(), b.otherPoints.size());
  for (std::size_t i = 0; i < a.otherPoints.size(); ++i) {
    ASSERT_EQ(a.otherPoints[i].kind, b.otherPoints[i].kind) << "point " << i;
    ASSERT_EQ(a.otherPoints[i].halfEdge, b.otherPoints[i].halfEdge) << "point " << i;
  }
}

/// Two steps of each form, of meshes whose vertices differ in valence, and of their children, whose runs touch.
void expectFormsAgree(const Far::Topology& control) {
  for (const Forms& forms : kForms) {
    SCOPED_TRACE(forms.name);
    if (forms.threeEdges && hasTwoValentVertex(control)) continue;
    const Far::SplitResult first = forms.closed(control);
    expectSame(first, forms.slots(control));
    for (const Forms& then : kForms) {
      SCOPED_TRACE("then " + then.name);
      if (then.threeEdges && hasTwoValentVertex(first.topology)) continue;
      expectSame(then.closed(first.topology), then.slots(first.topology));
    }
  }
}

TEST(ClosedForms, EqualTheSlotsElementForElementOnRandomMeshes) {
  for (std::uint64_t seed = 0; seed < meshes(40); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expectFormsAgree(toTopology(randomMesh(seed, Border::closed).mesh));
  }
}

TEST(ClosedForms, EqualTheSlotsWhereLoopsRunInPieces) {
  for (const PolyMesh& mesh : {torus(60, 40), prism(3000), tetrahedron()}) expectFormsAgree(toTopology(mesh));
}

}  // namespace
}  // namespace honeycomb::Test
