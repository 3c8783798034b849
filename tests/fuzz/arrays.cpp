#include "tests/fuzz/arrays.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <memory>

#include "far/base/index.h"

namespace honeycomb::Fuzz {
namespace {

using Tables = std::unique_ptr<hc_tables, decltype(&hc_tables_destroy)>;
using Evaluator = std::unique_ptr<hc_evaluator, decltype(&hc_evaluator_destroy)>;

void succeed(hc_status status) {
  expect(status == HC_OK, status == HC_OK ? "" : hc_last_message());
}

hc_tables_info infoOf(const Tables& tables) {
  hc_tables_info info{};
  info.struct_size = sizeof(info);
  succeed(hc_tables_get_info(tables.get(), &info));
  return info;
}

hc_level_counts countsOf(const Tables& tables, std::int32_t level) {
  hc_level_counts counts{};
  counts.struct_size = sizeof(counts);
  succeed(hc_tables_get_counts(tables.get(), level, &counts));
  return counts;
}

template <class Item, class Write>
std::vector<Item> written(const Tables& tables, std::int32_t level, Write write, std::int64_t count) {
  std::vector<Item> items(at(count));
  succeed(write(tables.get(), level, items.data(), count));
  return items;
}

bool areVertices(std::span<const std::int32_t> indices, const hc_level_counts& counts) {
  return std::ranges::all_of(indices, [&](std::int32_t v) { return v >= 0 && v < counts.vertices; });
}

bool areOrigins(std::span<const hc_origin> origins, const hc_level_counts& control) {
  return std::ranges::all_of(origins, [&](const hc_origin& origin) {
    const std::int64_t count = origin.kind == HC_ELEMENT_FACE ? control.faces : control.vertices;
    return origin.number >= 0 && origin.number < count && origin.level >= 0;
  });
}

/// The mesh of a level leads nowhere but to its own vertices.
void useLevel(const Tables& tables, std::int32_t level) {
  const hc_level_counts counts = countsOf(tables, level);
  const std::int32_t *offsets = nullptr, *vertices = nullptr;
  succeed(hc_tables_faces(tables.get(), level, &offsets, &vertices));
  expect(std::is_sorted(offsets, offsets + counts.faces + 1) && offsets[counts.faces] == counts.corners,
         "faces take all corners of the level");
  expect(areVertices({vertices, at(counts.corners)}, counts), "corners are vertices of the level");
  expect(areVertices(written<std::int32_t>(tables, level, hc_tables_triangles, counts.triangle_indices), counts),
         "triangles are of vertices");
  expect(areVertices(written<std::int32_t>(tables, level, hc_tables_lines, counts.line_indices), counts),
         "lines are of vertices");
  const hc_level_counts control = countsOf(tables, 0);
  expect(areOrigins(written<hc_origin>(tables, level, hc_tables_face_origins, counts.faces), control),
         "faces descend from control faces and vertices");
  expect(areOrigins(written<hc_origin>(tables, level, hc_tables_vertex_origins, counts.vertices), control),
         "vertices descend from control faces and vertices");
}

/// The same bits, but for NaN: where finite points are so large that sums of them overflow, its sign is the
/// processor's.
bool same(const std::vector<float>& a, const std::vector<float>& b) {
  return std::ranges::equal(a, b, [](float x, float y) {
    return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y) || (std::isnan(x) && std::isnan(y));
  });
}

/// What an evaluator gives.
struct Frame {
  hc_status status = HC_OK;
  std::vector<float> points, normals, limits;

  bool operator==(const Frame& other) const {
    return status == other.status && same(points, other.points) && same(normals, other.normals) &&
           same(limits, other.limits);
  }
};

hc_points_out packed(std::vector<float>& numbers) {
  return {numbers.data(), numbers.size(), 0, 3, 3};
}

void addLimits(const Evaluator& evaluator, const Tables& tables, const hc_level_counts& counts, Frame& frame) {
  const hc_points from = {frame.points.data(), frame.points.size(), 0, 3, 3};
  for (const auto& [kind, count] : {std::pair{HC_ELEMENT_VERTEX, counts.vertices}, {HC_ELEMENT_FACE, counts.faces}}) {
    std::vector<float> positions(3 * at(count));
    const hc_points_out out = packed(positions);
    const hc_status status = hc_evaluate_limits(evaluator.get(), tables.get(), kind, &from, &out, nullptr);
    expect(status == HC_OK || status == HC_ERROR_INVALID_POSITIONS, "limits of finite points are found");
    frame.limits.insert(frame.limits.end(), positions.begin(), positions.end());
  }
}

Frame frameBy(hc_backend backend, const Tables& tables, const std::vector<float>& control) {
  hc_evaluator_options options{};
  options.struct_size = sizeof(options);
  options.backend = backend;
  hc_evaluator* made = nullptr;
  succeed(hc_evaluator_create(nullptr, &options, &made));
  const Evaluator evaluator(made, hc_evaluator_destroy);
  const hc_tables_info info = infoOf(tables);
  const hc_level_counts counts = countsOf(tables, info.level_count);
  Frame frame;
  frame.points.resize(3 * at(counts.points));
  if (info.normals != HC_NORMALS_NONE) frame.normals.resize(3 * at(counts.points));
  const hc_points from = {control.data(), control.size(), 0, 3, 3};
  const hc_points_out refined = packed(frame.points), normals = packed(frame.normals);
  frame.status = hc_evaluate(evaluator.get(), tables.get(), info.level_count, &from, &refined,
                             frame.normals.empty() ? nullptr : &normals);
  // What is written before an error is nobody's.
  if (frame.status != HC_OK) return {frame.status, {}, {}, {}};
  if (info.limits == 1) addLimits(evaluator, tables, counts, frame);
  return frame;
}

/// All evaluators give the same bits, or refuse alike.
void useEvaluators(const Tables& tables, const std::vector<float>& points) {
  const hc_tables_info info = infoOf(tables);
  std::vector<float> control(3 * at(info.control_points));
  for (std::size_t i = 0; i < control.size(); ++i) control[i] = points[i % points.size()];
  const Frame serial = frameBy(HC_BACKEND_SERIAL, tables, control);
  const bool finite = std::ranges::all_of(control, [](float x) { return std::isfinite(x); });
  expect((serial.status == HC_OK) == finite, "finite points are evaluated, no others");
  expect(frameBy(HC_BACKEND_SIMD, tables, control) == serial, "vectors give the bits of plain loops");
  expect(frameBy(HC_BACKEND_TBB, tables, control) == serial, "threads give the bits of one");
  if (info.tiles == 1) expect(frameBy(HC_BACKEND_SIMD_TILED, tables, control) == serial, "tiles give the same bits");
}

}  // namespace

bool arrays(Bytes bytes) {
  const ArrayCall call(bytes);
  const hc_polygons polygons = call.polygons();
  const hc_tables_options options = call.options();
  hc_tables* made = nullptr;
  const hc_status status = hc_tables_create(nullptr, &polygons, &options, &made);
  expect((status == HC_OK) == (made != nullptr), "tables are made, or an error");
  expect(status != HC_ERROR_INTERNAL, "no input is the library's own fault");
  const Tables tables(made, hc_tables_destroy);
  if (status != HC_OK) return false;
  const hc_tables_info info = infoOf(tables);
  for (std::int32_t level = 0; level <= info.level_count; ++level) useLevel(tables, level);
  useEvaluators(tables, call.points);
  return true;
}

}  // namespace honeycomb::Fuzz
