#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

#include "tests/support/golden.h"
#include "tests/support/refined.h"

namespace honeycomb::Test {
namespace {

constexpr std::int32_t kNone = -1;

struct HalfEdgeArrays {
  std::vector<std::int32_t> next, prev, twin, vert, face, edge;
  std::size_t size() const { return next.size(); }
};

HalfEdgeArrays readHalfEdges(const std::string& name) {
  HalfEdgeArrays a;
  for (const auto& row : readGoldenCsv(name)) {
    std::size_t column = 1;
    for (auto* array : {&a.next, &a.prev, &a.twin, &a.vert, &a.face, &a.edge})
      array->push_back(std::stoi(row[column++]));
  }
  return a;
}

/// What a golden face was made from, by its number: the kept faces in order, then the vertices that get a face in
/// order.
struct Label {
  Far::FaceParent parent = Far::FaceParent::face;
  std::int32_t id = 0;
  bool operator==(const Label&) const = default;
};

struct HalfEdgeCase {
  const char* file;
  const char* shape;
  ReferenceBoundary boundary;
};

void PrintTo(const HalfEdgeCase& c, std::ostream* out) {
  *out << c.file;
}

std::vector<Label> goldenLabels(const HalfEdgeCase& c, const PolyMesh& mesh) {
  // The tests' own implementation makes its faces in the same order.
  const SchemeCase scheme = schemeCase(NamedTension::paper, c.boundary);
  std::vector<Label> labels;
  for (const ReferenceParent& p : referenceLevel(mesh, {}, scheme.reference, 1).parents) {
    labels.push_back({p.vertex ? Far::FaceParent::vertex : Far::FaceParent::face, static_cast<std::int32_t>(p.id)});
  }
  return labels;
}

/// The same of the product's faces, in the caller's numbers.
std::vector<Label> productLabels(const Far::Refinement& refinement) {
  const Far::Topology& control = refinement.level(0).topology;
  const Far::Topology& topology = refinement.level(1).topology;
  std::vector<Label> labels;
  for (const Far::FaceRun& run : topology.runs()) {
    for (std::int32_t f = run.firstFace; f < run.firstFace + run.faceCount; ++f) {
      const std::int32_t p = at(topology.parents(), f);
      labels.push_back({run.parent, run.parent == Far::FaceParent::face ? control.inputFace(p) : p});
    }
  }
  return labels;
}

/// Carries golden half-edges onto the product's from a first pair along next and twin. Empty when something differs.
class Isomorphism {
 public:
  Isomorphism(const HalfEdgeArrays& golden, std::vector<Label> goldenLabel, const Far::Refinement& refinement)
      : g_(golden),
        goldenLabel_(std::move(goldenLabel)),
        t_(refinement.level(1).topology),
        label_(productLabels(refinement)),
        map_(golden.size(), kNone),
        vertexMap_(static_cast<std::size_t>(t_.vertexCount()), kNone) {}

  bool walk(std::int32_t golden, std::int32_t product) {
    std::vector<std::pair<std::int32_t, std::int32_t>> open{{golden, product}};
    while (!open.empty()) {
      const auto [h, k] = open.back();
      open.pop_back();
      if (at(map_, h) == k) continue;
      if (at(map_, h) != kNone || !agrees(h, k)) return false;
      at(map_, h) = k;
      open.emplace_back(at(g_.next, h), t_.next(k));
      open.emplace_back(at(g_.prev, h), t_.prev(k));
      if (at(g_.twin, h) >= 0) open.emplace_back(at(g_.twin, h), t_.twin(k));
    }
    return true;
  }

  const std::vector<std::int32_t>& map() const { return map_; }

 private:
  bool agrees(std::int32_t h, std::int32_t k) {
    if ((at(g_.twin, h) < 0) != (t_.twin(k) < 0)) return false;
    if (at(goldenLabel_, at(g_.face, h)) != at(label_, t_.face(k))) return false;
    std::int32_t& image = at(vertexMap_, at(g_.vert, h));
    if (image == kNone) image = t_.vert(k);
    return image == t_.vert(k);
  }

  const HalfEdgeArrays& g_;
  std::vector<Label> goldenLabel_;
  const Far::Topology& t_;
  std::vector<Label> label_;
  std::vector<std::int32_t> map_;
  std::vector<std::int32_t> vertexMap_;
};

class GoldenHalfEdges : public testing::TestWithParam<HalfEdgeCase> {};

TEST_P(GoldenHalfEdges, AreTheTopologysUpToTheSlotToLoopMap) {
  const HalfEdgeCase c = GetParam();
  const HalfEdgeArrays golden = readHalfEdges(std::string("halfedge/") + c.file);
  const PolyMesh mesh = readGoldenMesh(std::string(c.shape) + ".obj");
  const Far::Refinement refinement = refined(mesh, schemeCase(NamedTension::paper, c.boundary).scheme, 1);
  const Far::Topology& topology = refinement.level(1).topology;
  ASSERT_EQ(golden.size(), static_cast<std::size_t>(topology.halfEdgeCount()));
  const std::vector<Label> labels = goldenLabels(c, mesh);
  ASSERT_EQ(labels.size(), static_cast<std::size_t>(topology.faceCount()));

  // Slot A of the first kept face's first half-edge has id 0; it may lie anywhere. The faces' labels leave one place.
  std::vector<std::vector<std::int32_t>> found;
  for (std::int32_t k = 0; k < topology.halfEdgeCount(); ++k) {
    Isomorphism isomorphism(golden, labels, refinement);
    if (isomorphism.walk(0, k)) found.push_back(isomorphism.map());
  }
  ASSERT_EQ(found.size(), 1U) << "places where the golden half-edges fit";
  std::vector<std::int32_t> images = found[0];
  std::sort(images.begin(), images.end());
  for (std::size_t h = 0; h < images.size(); ++h)
    ASSERT_EQ(images[h], static_cast<std::int32_t>(h)) << "not a bijection";
}

TEST_P(GoldenHalfEdges, PutSlotAInThePlaceOfItsHalfEdge) {
  const HalfEdgeCase c = GetParam();
  // Across slot A of half-edge (f, i) lies C of the next half-edge, in the face of vertex i+1 of f.
  const PolyMesh mesh = readGoldenMesh(std::string(c.shape) + ".obj");
  const Far::Refinement refinement = refined(mesh, schemeCase(NamedTension::paper, c.boundary).scheme, 1);
  const Far::Topology& control = refinement.level(0).topology;
  const Far::Topology& topology = refinement.level(1).topology;
  const std::vector<Label> labels = productLabels(refinement);
  for (const Far::FaceRun& run : topology.runs()) {
    if (run.parent != Far::FaceParent::face) continue;
    for (std::int32_t h = run.firstHalfEdge; h < run.firstHalfEdge + run.sides * run.faceCount; ++h) {
      const std::int32_t f = at(topology.parents(), topology.face(h));
      const std::int32_t place = h - at(topology.faceOffsets(), topology.face(h));
      const std::int32_t parent = at(control.faceOffsets(), f) + place;
      if (topology.twin(h) < 0) continue;
      EXPECT_EQ(labels[static_cast<std::size_t>(topology.face(topology.twin(h)))],
                (Label{Far::FaceParent::vertex, control.dest(parent)}))
          << "half-edge " << h << " of the face of face " << f;
    }
  }
}

std::string caseName(const testing::TestParamInfo<HalfEdgeCase>& testInfo) {
  const std::string file = testInfo.param.file;
  return file.substr(0, file.rfind('.'));
}

INSTANTIATE_TEST_SUITE_P(Zip, GoldenHalfEdges,
                         testing::Values(HalfEdgeCase{"zip_tetrahedron.csv", "tetrahedron", ReferenceBoundary::brick},
                                         HalfEdgeCase{"zip_cube.csv", "cube", ReferenceBoundary::brick},
                                         HalfEdgeCase{"zip_grid.csv", "grid", ReferenceBoundary::drop},
                                         HalfEdgeCase{"zip_honeycomb.csv", "honeycomb", ReferenceBoundary::drop},
                                         HalfEdgeCase{"zipbrick_grid.csv", "grid", ReferenceBoundary::brick},
                                         HalfEdgeCase{"zipbrick_honeycomb.csv", "honeycomb", ReferenceBoundary::brick}),
                         caseName);

}  // namespace
}  // namespace honeycomb::Test
