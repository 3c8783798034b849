// The C API gives what the C++ API gives, bit for bit.
#include <gtest/gtest.h>

#include <memory>
#include <thread>

#include "capi/include/honeycomb.h"
#include "far/base/index.h"
#include "far/schemes/akleman.h"
#include "far/schemes/half_box.h"
#include "far/schemes/zhang_wang.h"
#include "far/tables/normal_rule.h"
#include "osd/cpu_evaluator.h"
#include "osd/normal_evaluator.h"
#include "tests/support/golden.h"
#include "tests/support/must.h"
#include "tests/support/random.h"
#include "tests/support/refined.h"
#include "tests/support/same_bits.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

using honeycomb::at;
using Tables = std::unique_ptr<hc_tables, decltype(&hc_tables_destroy)>;
using Evaluator = std::unique_ptr<hc_evaluator, decltype(&hc_evaluator_destroy)>;

void mustC(hc_status status) {
  if (status != HC_OK) throw std::runtime_error(hc_last_message());
}

hc_polygons viewOf(const Far::Polygons& polygons, const std::vector<hc_crease>& creases) {
  hc_polygons view{};
  view.struct_size = sizeof(view);
  view.vertex_count = polygons.vertexCount;
  view.face_count = polygons.faceCount();
  view.face_offsets = polygons.faceOffsets.data();
  view.face_vertices = polygons.indices.data();
  view.face_vertex_count = std::ssize(polygons.indices);
  view.creases = creases.data();
  view.crease_count = std::ssize(creases);
  view.corners = polygons.corners.data();
  view.corner_count = std::ssize(polygons.corners);
  return view;
}

Tables tablesOf(const Far::Polygons& polygons, hc_tables_options options) {
  std::vector<hc_crease> creases;
  for (const Far::Crease& crease : polygons.creases)
    creases.push_back({crease.vertex0, crease.vertex1, crease.sharpness});
  const hc_polygons view = viewOf(polygons, creases);
  options.struct_size = sizeof(options);
  hc_tables* tables = nullptr;
  mustC(hc_tables_create(nullptr, &view, &options, &tables));
  return {tables, hc_tables_destroy};
}

Evaluator evaluatorOf(hc_backend backend) {
  const hc_evaluator_options options{sizeof(options), backend, 0};
  hc_evaluator* evaluator = nullptr;
  mustC(hc_evaluator_create(nullptr, &options, &evaluator));
  return {evaluator, hc_evaluator_destroy};
}

hc_level_counts countsOf(const Tables& tables, std::int32_t level) {
  hc_level_counts counts{};
  counts.struct_size = sizeof(counts);
  mustC(hc_tables_get_counts(tables.get(), level, &counts));
  return counts;
}

std::vector<float> randomNumbers(std::int64_t count) {
  Random random(7);
  std::vector<float> numbers(at(count));
  for (float& number : numbers) number = static_cast<float>(random.symmetric());
  return numbers;
}

/// A mesh and a chain, by both ways: what the C API calls it, and what C++ makes it of.
struct Case {
  const char* scheme;
  std::vector<hc_option> options;
  Far::Polygons polygons;
  Result<std::vector<Far::Scheme>> (*chain)(const Far::Topology&);
  bool centralPoints = false;
};

Far::Polygons creasedGrid() {
  Far::Polygons polygons = toPolygons(grid(4, 3), {0});
  polygons.creases.push_back({polygons.indices[0], polygons.indices[1], 1.5});
  for (const std::int64_t f : {4, 5})
    polygons.creases.push_back({polygons.indices[at(4 * f)], polygons.indices[at(4 * f + 1)], 2.5});
  return polygons;
}

Result<std::vector<Far::Scheme>> aklemanChain(const Far::Topology&) {
  Far::AklemanOptions options;
  options.tension = {Far::Tension::Rule::sqrt3};
  options.edgeParameter = 0.25;
  return Far::akleman(options).map([](const Far::Scheme& step) { return std::vector(2, step); });
}

Result<std::vector<Far::Scheme>> zhangWangChain(const Far::Topology& control) {
  return Far::zhangWang(control, 2);
}

Result<std::vector<Far::Scheme>> mixedChain(const Far::Topology& control) {
  const Result<Far::Scheme> first = Far::akleman();
  if (!first) return tl::unexpected(first.error());
  const Far::Topology between = must(first->split.apply(control)).topology;
  std::vector<Far::Scheme> steps = must(Far::halfBox(between, 1, {.tuning = Far::HalfBoxTuning::first}));
  steps.insert(steps.begin(), *first);
  return steps;
}

std::vector<Case> cases() {
  return {{"akleman", {{"tension", "sqrt3"}, {"edge-parameter", "0.25"}}, creasedGrid(), aklemanChain},
          {"zhang-wang", {}, toPolygons(readGoldenMesh("mixed.obj")), zhangWangChain, true},
          {"akleman:1,half-box:1", {{"tuned", "first"}}, toPolygons(prism(5)), mixedChain}};
}

/// One case, built by both with a kind of normals.
struct Both {
  Both(const Case& which, hc_normals normals, int tiles)
      : topology(must(Far::Topology::create(which.polygons))),
        cpp(must(Far::refine(topology, must(which.chain(topology)), {which.centralPoints, true, 0}))),
        c(tablesOf(which.polygons, optionsOf(which, normals, tiles))) {}

  static hc_tables_options optionsOf(const Case& which, hc_normals normals, int tiles) {
    hc_tables_options options{};
    options.scheme = which.scheme;
    options.options = which.options.data();
    options.option_count = which.options.size();
    options.normals = normals;
    options.tiles = tiles;
    options.limits = 1;
    options.central_points = which.centralPoints;
    return options;
  }

  Far::Topology topology;
  Far::Refinement cpp;
  Tables c;
};

std::vector<std::int32_t> indicesOf(const Both& both, std::int32_t level,
                                    hc_status (*write)(const hc_tables*, std::int32_t, std::int32_t*, std::int64_t),
                                    std::int64_t count) {
  std::vector<std::int32_t> indices(at(count));
  mustC(write(both.c.get(), level, indices.data(), count));
  return indices;
}

TEST(CApi, IndexBuffersOfEveryLevelAreThoseOfCpp) {
  for (const Case& which : cases()) {
    SCOPED_TRACE(which.scheme);
    const Both both(which, HC_NORMALS_NONE, 0);
    for (std::int32_t level = 0; level <= both.cpp.levelCount(); ++level) {
      const Far::Topology& mesh = both.cpp.level(level).topology;
      const hc_level_counts counts = countsOf(both.c, level);
      EXPECT_EQ(counts.points, both.cpp.level(level).pointCount());
      EXPECT_EQ(counts.boundary_edges, mesh.boundaryEdgeCount());
      const std::int32_t *offsets = nullptr, *vertices = nullptr;
      mustC(hc_tables_faces(both.c.get(), level, &offsets, &vertices));
      EXPECT_TRUE(std::ranges::equal(std::span(offsets, at(counts.faces) + 1), mesh.faceOffsets()));
      EXPECT_TRUE(std::ranges::equal(std::span(vertices, at(counts.corners)), mesh.vert()));
      EXPECT_EQ(indicesOf(both, level, hc_tables_triangles, counts.triangle_indices), both.cpp.triangles(level));
      EXPECT_EQ(indicesOf(both, level, hc_tables_lines, counts.line_indices), both.cpp.lines(level));
    }
  }
}

TEST(CApi, OriginsAreThoseOfCppInTheCallersNumbers) {
  for (const Case& which : cases()) {
    SCOPED_TRACE(which.scheme);
    const Both both(which, HC_NORMALS_NONE, 0);
    const std::int32_t level = both.cpp.levelCount();
    const hc_level_counts counts = countsOf(both.c, level);
    std::vector<hc_origin> faces(at(counts.faces)), vertices(at(counts.vertices));
    mustC(hc_tables_face_origins(both.c.get(), level, faces.data(), counts.faces));
    mustC(hc_tables_vertex_origins(both.c.get(), level, vertices.data(), counts.vertices));
    const auto expectSame = [&](const std::vector<hc_origin>& c, const std::vector<Far::Origin>& cpp) {
      ASSERT_EQ(c.size(), cpp.size());
      for (std::size_t i = 0; i < c.size(); ++i) {
        EXPECT_EQ(c[i].level, cpp[i].level);
        EXPECT_EQ(c[i].kind == HC_ELEMENT_VERTEX, cpp[i].vertex);
        EXPECT_EQ(c[i].number, cpp[i].vertex ? cpp[i].element : both.topology.inputFace(cpp[i].element));
      }
    };
    expectSame(faces, both.cpp.faceOrigins(level));
    expectSame(vertices, both.cpp.vertexOrigins(level));
  }
}

constexpr hc_backend kBackends[]{HC_BACKEND_AUTO, HC_BACKEND_SERIAL,     HC_BACKEND_SIMD,
                                 HC_BACKEND_TBB,  HC_BACKEND_SIMD_TILED, HC_BACKEND_TBB_TILED};

/// The points of a level by the C API, of any layout; what isn't described stays -7.
std::vector<float> levelByC(const Both& both, hc_backend backend, std::int32_t level, const std::vector<float>& control,
                            const Osd::BufferDescriptor& desc) {
  std::vector<float> refined(at(desc.extent(countsOf(both.c, level).points)), -7.0F);
  const hc_points from{control.data(), control.size(), desc.offset, desc.length, desc.stride};
  const hc_points_out to{refined.data(), refined.size(), desc.offset, desc.length, desc.stride};
  mustC(hc_evaluate(evaluatorOf(backend).get(), both.c.get(), level, &from, &to, nullptr));
  return refined;
}

std::vector<float> levelByCpp(const Both& both, std::int32_t level, const std::vector<float>& control,
                              const Osd::BufferDescriptor& desc) {
  std::vector<float> refined(at(desc.extent(both.cpp.level(level).pointCount())), -7.0F);
  must(Osd::SerialEvaluator().evaluate<float>(both.cpp, level, {control, desc}, {refined, desc}));
  return refined;
}

TEST(CApi, PointsOfEveryBackendLevelAndLayoutAreThoseOfCpp) {
  constexpr Osd::BufferDescriptor kLayouts[]{{0, 3, 3}, {2, 2, 5}, {0, 7, 7}};
  for (const Case& which : cases()) {
    const Both both(which, HC_NORMALS_NONE, 1);
    for (const Osd::BufferDescriptor& desc : kLayouts) {
      const std::vector<float> control = randomNumbers(desc.extent(both.cpp.level(0).pointCount()));
      for (std::int32_t level = 1; level <= both.cpp.levelCount(); ++level) {
        const std::vector<float> expected = levelByCpp(both, level, control, desc);
        for (const hc_backend backend : kBackends)
          EXPECT_TRUE(sameBits(levelByC(both, backend, level, control, desc), expected))
              << which.scheme << ", backend " << backend << ", level " << level << ", length " << desc.length;
      }
    }
  }
}

/// Points and normals of the last level, interleaved: x y z, a gap, the normal, a gap.
std::vector<float> withNormalsByC(const Both& both, hc_backend backend, const std::vector<float>& control) {
  std::vector<float> all(8 * at(countsOf(both.c, both.cpp.levelCount()).points), -7.0F);
  const hc_points from{control.data(), control.size(), 0, 3, 3};
  const hc_points_out points{all.data(), all.size(), 0, 3, 8}, normals{all.data(), all.size(), 4, 3, 8};
  mustC(hc_evaluate(evaluatorOf(backend).get(), both.c.get(), both.cpp.levelCount(), &from, &points, &normals));
  return all;
}

std::vector<float> withNormalsByCpp(const Both& both, hc_normals kind, const std::vector<float>& control) {
  std::vector<float> all(8 * at(both.cpp.last().pointCount()), -7.0F);
  const Osd::PointsOut<float> points{all, {0, 3, 8}}, normals{all, {4, 3, 8}};
  if (kind == HC_NORMALS_FAST) {
    const Far::NormalTable table = must(Far::buildNormalTable(both.cpp, both.cpp.levelCount()));
    must(Osd::NormalEvaluator(Osd::CpuEvaluator::Threads::one)
             .evaluate<float>(both.cpp, table, {control, {}}, points, normals));
    return all;
  }
  Osd::SerialEvaluator evaluator;
  must(evaluator.evaluate<float>(both.cpp, both.cpp.levelCount(), {control, {}}, points));
  must(evaluator.vertexLimits<float>(both.cpp.limits(), {all, {0, 3, 8}}, {}, normals));
  for (std::int32_t p = both.cpp.last().topology.vertexCount(); p < both.cpp.last().pointCount(); ++p)
    std::fill_n(&all[8 * at(p) + 4], 3, 0.0F);  // central control vertices have none
  return all;
}

class CApiNormals : public testing::TestWithParam<hc_normals> {};

TEST_P(CApiNormals, OfEveryBackendAreThoseOfCppAndMayStandBetweenThePoints) {
  for (const Case& which : cases()) {
    const Both both(which, GetParam(), 1);
    const std::vector<float> control = randomNumbers(3 * both.cpp.level(0).pointCount());
    const std::vector<float> expected = withNormalsByCpp(both, GetParam(), control);
    for (const hc_backend backend : kBackends)
      EXPECT_TRUE(sameBits(withNormalsByC(both, backend, control), expected))
          << which.scheme << ", backend " << backend;
  }
}

INSTANTIATE_TEST_SUITE_P(All, CApiNormals, testing::Values(HC_NORMALS_FAST, HC_NORMALS_EXACT));

TEST(CApi, LimitsAreThoseOfCpp) {
  const Both both(cases().front(), HC_NORMALS_NONE, 0);
  const std::vector<float> points = randomNumbers(3 * both.cpp.last().pointCount());
  const hc_points from{points.data(), points.size(), 0, 3, 3};
  const Far::Topology& mesh = both.cpp.last().topology;
  for (const hc_element kind : {HC_ELEMENT_VERTEX, HC_ELEMENT_FACE}) {
    const std::size_t count = at(kind == HC_ELEMENT_VERTEX ? mesh.vertexCount() : mesh.faceCount());
    std::vector<float> c(6 * count), cpp(6 * count);
    const hc_points_out positions{c.data(), c.size(), 0, 3, 6}, normals{c.data(), c.size(), 3, 3, 6};
    const Evaluator evaluator = evaluatorOf(HC_BACKEND_TBB);
    mustC(hc_evaluate_limits(evaluator.get(), both.c.get(), kind, &from, &positions, &normals));
    Osd::SerialEvaluator serial;
    const Osd::PointsOut<float> places{cpp, {0, 3, 6}}, directions{cpp, {3, 3, 6}};
    must(kind == HC_ELEMENT_VERTEX ? serial.vertexLimits<float>(both.cpp.limits(), {points, {}}, places, directions)
                                   : serial.faceLimits<float>(both.cpp.limits(), {points, {}}, places, directions));
    EXPECT_TRUE(sameBits(c, cpp)) << "kind " << kind;
  }
}

TEST(CApi, TaggedCornersAndSpatialOrderAreThoseOfCpp) {
  const Far::Polygons polygons = toPolygons(grid(5, 4));
  const hc_option keep{"corners", "valence2"};
  hc_tables_options options{};
  options.options = &keep;
  options.option_count = 1;
  options.levels = 1;
  options.order = HC_ORDER_SPATIAL;
  const Tables tables = tablesOf(polygons, options);
  Far::Polygons tagged = polygons;
  for (std::int32_t v = 0; v < polygons.vertexCount; ++v)
    if (std::ranges::count(polygons.indices, v) == 1) tagged.corners.push_back(v);
  const Far::Topology control = must(Far::Topology::create(tagged, Far::FaceOrder::spatial));
  const Far::Refinement cpp = must(Far::refine(control, must(Far::akleman()), 1));
  ASSERT_EQ(tagged.corners.size(), 4U);
  const std::vector<float> points = randomNumbers(3 * control.vertexCount());
  std::vector<float> c(3 * at(cpp.last().pointCount())), expected(c.size());
  const hc_points from{points.data(), points.size(), 0, 3, 3};
  const hc_points_out to{c.data(), c.size(), 0, 3, 3};
  mustC(hc_evaluate(evaluatorOf(HC_BACKEND_SERIAL).get(), tables.get(), 1, &from, &to, nullptr));
  must(Osd::SerialEvaluator().evaluate<float>(cpp, 1, {points, {}}, {expected, {}}));
  EXPECT_TRUE(sameBits(c, expected));
}

TEST(CApi, ThreadsShareTablesAndHaveMessagesOfTheirOwn) {
  const Both both(cases().front(), HC_NORMALS_FAST, 1);
  const std::vector<float> control = randomNumbers(3 * both.cpp.level(0).pointCount());
  const std::vector<float> expected = withNormalsByCpp(both, HC_NORMALS_FAST, control);
  std::vector<std::string> messages(4);
  std::vector<char> same(4, 0);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < 4; ++i)
    threads.emplace_back([&, i] {
      const auto level = static_cast<std::int32_t>(90 + i);
      for (int turn = 0; turn < 20; ++turn) (void)hc_tables_faces(both.c.get(), level, nullptr, nullptr);
      same[i] = sameBits(withNormalsByC(both, kBackends[i], control), expected);
      messages[i] = hc_last_message();
    });
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_TRUE(same[i]) << "thread " << i;
    EXPECT_EQ(messages[i], "level " + std::to_string(90 + i) + " is out of range; use 0 to 2");
  }
}

}  // namespace
}  // namespace honeycomb::Test
