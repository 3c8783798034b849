#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <ostream>
#include <stdexcept>
#include <string_view>

#include "far/topology/splits/ambo.h"
#include "far/topology/splits/chamfer.h"
#include "far/topology/splits/expand.h"
#include "far/topology/splits/truncate.h"
#include "far/topology/splits/zip.h"
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

/// What a face was made from, in the caller's numbers; an edge by its lower and its higher vertex.
struct Label {
  Far::FaceParent parent = Far::FaceParent::face;
  std::int32_t id = 0;
  std::int32_t other = 0;
  bool operator==(const Label&) const = default;
};

struct HalfEdgeCase {
  const char* file;
  const char* shape;
  ReferenceBoundary boundary = ReferenceBoundary::brick;  ///< of zip

  bool isZip() const { return std::string_view(file).starts_with("zip"); }
  std::string split() const { return std::string(file).substr(0, std::string_view(file).find('_')); }
};

void PrintTo(const HalfEdgeCase& c, std::ostream* out) {
  *out << c.file;
}

/// The tests' own implementation of zip makes its faces in the golden order.
std::vector<Label> goldenZipLabels(const HalfEdgeCase& c, const PolyMesh& mesh) {
  const SchemeCase scheme = schemeCase(NamedTension::paper, c.boundary);
  std::vector<Label> labels;
  for (const ReferenceParent& p : referenceLevel(mesh, {}, scheme.reference, 1).parents) {
    labels.push_back({p.vertex ? Far::FaceParent::vertex : Far::FaceParent::face, static_cast<std::int32_t>(p.id)});
  }
  return labels;
}

/// Edges of a mesh by their vertices, in order of first appearance, and how many faces each has.
std::vector<std::pair<Label, int>> edgesOf(const PolyMesh& mesh) {
  std::vector<std::pair<Label, int>> edges;
  for (const Loop& loop : mesh.faces) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto v = static_cast<std::int32_t>(loop[i]), w = static_cast<std::int32_t>(loop[(i + 1) % loop.size()]);
      const Label label{Far::FaceParent::edge, std::min(v, w), std::max(v, w)};
      const auto known = std::find_if(edges.begin(), edges.end(), [&](const auto& e) { return e.first == label; });
      if (known == edges.end()) {
        edges.emplace_back(label, 1);
      } else {
        ++known->second;
      }
    }
  }
  return edges;
}

/// Kept faces in order, then what the split makes of edges and vertices, each in order.
std::vector<Label> goldenLabels(const HalfEdgeCase& c, const PolyMesh& mesh) {
  if (c.isZip()) return goldenZipLabels(c, mesh);
  std::vector<Label> labels;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) labels.push_back({Far::FaceParent::face, static_cast<int>(f)});
  const bool edgeFaces = c.split() == "chamfer" || c.split() == "expand";
  const Far::Topology control = toTopology(mesh);
  for (const auto& [edge, faces] : edgesOf(mesh)) {
    if (edgeFaces && faces == 2) labels.push_back(edge);
  }
  for (std::int32_t v = 0; v < control.vertexCount(); ++v) {
    const bool face = c.split() == "expand" ? !control.onBoundary(v) : c.split() != "chamfer" && control.keepsFace(v);
    if (face) labels.push_back({Far::FaceParent::vertex, v});
  }
  return labels;
}

struct Step {
  Far::Topology control, child;
};

Step firstStep(const HalfEdgeCase& c, const PolyMesh& mesh) {
  const std::map<std::string, Far::Split> splits{{"chamfer", Far::chamfer()},
                                                 {"expand", Far::expand()},
                                                 {"ambo", Far::ambo()},
                                                 {"truncate", Far::truncate()},
                                                 {"zip", schemeCase(NamedTension::paper, c.boundary).scheme.split},
                                                 {"zipbrick", Far::zip(Far::BoundaryRule::brick)}};
  Step step{toTopology(mesh), {}};
  Result<Far::SplitResult> split = splits.at(c.split()).apply(step.control);
  if (!split) throw std::runtime_error(split.error().message);
  step.child = std::move(split->topology);
  return step;
}

/// The same of the product's faces.
std::vector<Label> productLabels(const Step& step) {
  std::vector<Label> labels;
  for (const Far::FaceRun& run : step.child.runs()) {
    for (std::int32_t f = run.firstFace; f < run.firstFace + run.faceCount; ++f) {
      const std::int32_t p = at(step.child.parents(), f);
      switch (run.parent) {
        case Far::FaceParent::face:
          labels.push_back({run.parent, step.control.inputFace(p)});
          break;
        case Far::FaceParent::vertex:
          labels.push_back({run.parent, p});
          break;
        case Far::FaceParent::edge:
          labels.push_back({run.parent, std::min(step.control.vert(p), step.control.dest(p)),
                            std::max(step.control.vert(p), step.control.dest(p))});
      }
    }
  }
  return labels;
}

/// Carries golden half-edges onto the product's from a first pair along next and twin. Empty when something differs.
class Isomorphism {
 public:
  Isomorphism(const HalfEdgeArrays& golden, std::vector<Label> goldenLabel, const Step& step)
      : g_(golden),
        goldenLabel_(std::move(goldenLabel)),
        t_(step.child),
        label_(productLabels(step)),
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
  const Step step = firstStep(c, mesh);
  const Far::Topology& topology = step.child;
  ASSERT_EQ(golden.size(), static_cast<std::size_t>(topology.halfEdgeCount()));
  const std::vector<Label> labels = goldenLabels(c, mesh);
  ASSERT_EQ(labels.size(), static_cast<std::size_t>(topology.faceCount()));

  // Slot A of the first kept face's first half-edge has id 0; it may lie anywhere. The faces' labels leave one place.
  std::vector<std::vector<std::int32_t>> found;
  for (std::int32_t k = 0; k < topology.halfEdgeCount(); ++k) {
    Isomorphism isomorphism(golden, labels, step);
    if (isomorphism.walk(0, k)) found.push_back(isomorphism.map());
  }
  ASSERT_EQ(found.size(), 1U) << "places where the golden half-edges fit";
  std::vector<std::int32_t> images = found[0];
  std::sort(images.begin(), images.end());
  for (std::size_t h = 0; h < images.size(); ++h)
    ASSERT_EQ(images[h], static_cast<std::int32_t>(h)) << "not a bijection";
}

class ZipHalfEdges : public testing::TestWithParam<HalfEdgeCase> {};

TEST_P(ZipHalfEdges, PutSlotAInThePlaceOfItsHalfEdge) {
  const HalfEdgeCase c = GetParam();
  // Across slot A of half-edge (f, i) lies C of the next half-edge, in the face of vertex i+1 of f.
  const PolyMesh mesh = readGoldenMesh(std::string(c.shape) + ".obj");
  const Step step = firstStep(c, mesh);
  const Far::Topology& control = step.control;
  const Far::Topology& topology = step.child;
  const std::vector<Label> labels = productLabels(step);
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

const std::vector<HalfEdgeCase> kZipCases{{"zip_tetrahedron.csv", "tetrahedron"},
                                          {"zip_cube.csv", "cube"},
                                          {"zip_grid.csv", "grid", ReferenceBoundary::drop},
                                          {"zip_honeycomb.csv", "honeycomb", ReferenceBoundary::drop},
                                          {"zipbrick_grid.csv", "grid"},
                                          {"zipbrick_honeycomb.csv", "honeycomb"}};
const std::vector<HalfEdgeCase> kOtherCases{{"chamfer_tetrahedron.csv", "tetrahedron"},
                                            {"chamfer_cube.csv", "cube"},
                                            {"chamfer_grid.csv", "grid"},
                                            {"chamfer_honeycomb.csv", "honeycomb"},
                                            {"expand_tetrahedron.csv", "tetrahedron"},
                                            {"expand_cube.csv", "cube"},
                                            {"expand_grid.csv", "grid"},
                                            {"expand_honeycomb.csv", "honeycomb"},
                                            {"ambo_tetrahedron.csv", "tetrahedron"},
                                            {"ambo_cube.csv", "cube"},
                                            {"ambo_grid.csv", "grid"},
                                            {"ambo_honeycomb.csv", "honeycomb"},
                                            {"truncate_tetrahedron.csv", "tetrahedron"},
                                            {"truncate_cube.csv", "cube"},
                                            {"truncate_grid.csv", "grid"},
                                            {"truncate_honeycomb.csv", "honeycomb"}};

INSTANTIATE_TEST_SUITE_P(Zip, GoldenHalfEdges, testing::ValuesIn(kZipCases), caseName);
INSTANTIATE_TEST_SUITE_P(Zip, ZipHalfEdges, testing::ValuesIn(kZipCases), caseName);
INSTANTIATE_TEST_SUITE_P(Split, GoldenHalfEdges, testing::ValuesIn(kOtherCases), caseName);

}  // namespace
}  // namespace honeycomb::Test
