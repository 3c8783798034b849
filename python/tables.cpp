#include "python/tables.h"

#include <algorithm>
#include <array>
#include <deque>
#include <string>

#include "python/arrays.h"
#include "python/failure.h"

namespace honeycomb::Python {
namespace {

constexpr std::array kNormals{"none", "fast", "exact"};
constexpr std::array kOrders{"input", "spatial"};

const py::object& checkedMesh(const py::object& given) {
  if (py::isinstance(given, py::module_::import("honeycomb.mesh").attr("Mesh"))) return given;
  throw py::type_error("mesh is " + typeName(given) + "; give a honeycomb.Mesh");
}

/// Polygons in the arrays of a honeycomb.Mesh, which are kept alive.
class MeshArrays {
 public:
  explicit MeshArrays(const py::object& mesh)
      : points_(checkedMesh(mesh).attr("points")),
        offsets_(mesh.attr("face_offsets")),
        vertices_(mesh.attr("face_vertices")),
        creases_(mesh.attr("creases")),
        corners_(mesh.attr("corners")) {}

  hc_polygons polygons() const {
    const auto offsets = listOf<std::int64_t>(offsets_, "face_offsets");
    const auto vertices = listOf<std::int32_t>(vertices_, "face_vertices");
    const auto creases = listOf<hc_crease>(creases_, "creases");
    const auto corners = listOf<std::int32_t>(corners_, "corners");
    hc_polygons polygons{};
    polygons.struct_size = sizeof polygons;
    polygons.vertex_count = static_cast<std::int32_t>(py::len(points_));
    polygons.face_count = std::ssize(offsets) - 1;
    polygons.face_offsets = offsets.data();
    polygons.face_vertices = vertices.data();
    polygons.face_vertex_count = std::ssize(vertices);
    polygons.creases = creases.data();
    polygons.crease_count = std::ssize(creases);
    polygons.corners = corners.data();
    polygons.corner_count = std::ssize(corners);
    return polygons;
  }

 private:
  py::object points_, offsets_, vertices_, creases_, corners_;
};

/// Keyword arguments as options of the command line: central_offset=0.5 is --central-offset 0.5, tuned=True a flag;
/// what is False or None was not given.
class SchemeWords {
 public:
  explicit SchemeWords(const py::kwargs& given) {
    for (const auto& [key, value] : given) {
      if (value.is_none() || value.is(py::bool_(false))) continue;
      std::string& name = texts_.emplace_back(py::str(key));
      std::replace(name.begin(), name.end(), '_', '-');
      const std::string& text = texts_.emplace_back(py::str(value));
      options_.push_back({name.c_str(), text.c_str()});
    }
  }
  const std::vector<hc_option>& options() const { return options_; }

 private:
  std::deque<std::string> texts_;
  std::vector<hc_option> options_;
};

struct Wanted {
  std::string scheme;
  std::int32_t levels;
  std::string normals;
  bool tiles, limits, centralPoints;
  std::string order;
  std::int64_t memoryLimit;
};

std::shared_ptr<Tables> create(const py::object& mesh, const Wanted& wanted, const py::kwargs& given) {
  const MeshArrays arrays(mesh);
  const hc_polygons polygons = arrays.polygons();
  const SchemeWords words(given);
  hc_tables_options options{};
  options.struct_size = sizeof options;
  options.scheme = wanted.scheme.c_str();
  options.levels = wanted.levels;
  options.options = words.options().data();
  options.option_count = words.options().size();
  options.normals = chosen(wanted.normals, kNormals, "normals");
  options.tiles = wanted.tiles;
  options.limits = wanted.limits;
  options.central_points = wanted.centralPoints;
  options.order = chosen(wanted.order, kOrders, "order");
  options.memory_limit = wanted.memoryLimit;
  hc_tables* tables = nullptr;
  unlocked([&] { return hc_tables_create(nullptr, &polygons, &options, &tables); });
  return std::make_shared<Tables>(tables);
}

std::shared_ptr<Tables> openTables(const std::filesystem::path& path, bool trusted) {
  hc_open_options options{};
  options.struct_size = sizeof options;
  options.trusted = trusted;
  hc_tables* tables = nullptr;
  unlocked([&] { return hc_tables_open(nullptr, path.c_str(), &options, &tables); });
  return std::make_shared<Tables>(tables);
}

using Level = std::optional<std::int32_t>;

py::tuple faces(const py::object& self, const Level& level) {
  const auto& tables = self.cast<const Tables&>();
  const std::int32_t *offsets = nullptr, *vertices = nullptr;
  check(hc_tables_faces(tables.get(), tables.level(level), &offsets, &vertices));
  const hc_level_counts counts = tables.counts(level);
  return py::make_tuple(viewOf(offsets, {counts.faces + 1}, self), viewOf(vertices, {counts.corners}, self));
}

using WriteIndices = hc_status (*)(const hc_tables*, std::int32_t, std::int32_t*, std::int64_t);

/// Triangles or lines: rows of indices, `columns` each.
py::array indices(const Tables& tables, const Level& level, const std::optional<py::object>& out, WriteIndices write,
                  std::int64_t count, std::int64_t columns) {
  py::array_t<std::int32_t> rows = indexRows(out, count / columns, columns);
  std::int32_t* data = rows.mutable_data();
  unlocked([&] { return write(tables.get(), tables.level(level), data, count); });
  return rows;
}

using WriteOrigins = hc_status (*)(const hc_tables*, std::int32_t, hc_origin*, std::int64_t);

py::array origins(const Tables& tables, const Level& level, WriteOrigins write, std::int64_t count) {
  py::array_t<hc_origin> result(count);
  hc_origin* data = result.mutable_data();
  unlocked([&] { return write(tables.get(), tables.level(level), data, count); });
  return result;
}

void addCounts(py::module_& module) {
  py::class_<hc_level_counts>(module, "Counts", "How many of what a level has; corners: the sides of all faces.")
      .def_readonly("points", &hc_level_counts::points,
                    "What evaluation reads or writes: vertices, and behind them central control vertices.")
      .def_readonly("vertices", &hc_level_counts::vertices)
      .def_readonly("edges", &hc_level_counts::edges)
      .def_readonly("faces", &hc_level_counts::faces)
      .def_readonly("corners", &hc_level_counts::corners)
      .def_readonly("boundary_edges", &hc_level_counts::boundary_edges);
}

constexpr const char* kTablesText = R"(All that a mesh's connectivity decides, built once. Never changes.

scheme          a name, "akleman", "half-box", .., or a chain such as "catmull-clark:1,akleman:2"
levels          of a scheme, 1 to 20; 0: 2. Of a chain 0 or their sum
normals         "none", "fast" or "exact": those of the last level that evaluators will be asked for
tiles           also build tiles, with which a frame takes a fraction of the time
limits          also build limit positions and normals of the last level
central_points  control points are vertices and behind them a central control vertex a face (zhang-wang)
order           of control faces: "input", or "spatial" where the given one is random
memory_limit    bytes the tables may take; 0: no limit
options         those of the scheme on the command line: boundary="eq16", tension="sqrt3", edge_parameter=0.3,
                tuned=True

Raises Error, its element being the face or vertex of the mesh that is wrong. Linear in the last level's vertices.)";

using Class = py::class_<Tables, std::shared_ptr<Tables>>;

void addMaking(Class& tables) {
  tables
      .def(py::init([](const py::object& mesh, const std::string& scheme, std::int32_t levels,
                       const std::string& normals, bool tiles, bool limits, bool centralPoints,
                       const std::string& order, std::int64_t memoryLimit, const py::kwargs& options) {
             return create(mesh, {scheme, levels, normals, tiles, limits, centralPoints, order, memoryLimit}, options);
           }),
           py::arg("mesh"), py::arg("scheme") = "akleman", py::arg("levels") = 0, py::kw_only(),
           py::arg("normals") = "none", py::arg("tiles") = false, py::arg("limits") = false,
           py::arg("central_points") = false, py::arg("order") = "input", py::arg("memory_limit") = 0)
      .def_static(
          "open", openTables, py::arg("path"), py::kw_only(), py::arg("trusted") = false,
          "Maps a table file (.hct) and uses it in place. It has the mesh of the last level alone. trusted: its "
          "indices are not proven, and a broken file then does anything. Raises Error.")
      .def(
          "save",
          [](const Tables& own, const std::filesystem::path& path) {
            unlocked([&] { return hc_tables_save(own.get(), path.c_str()); });
          },
          py::arg("path"), "Writes a table file, whole or not at all. Raises Error.");
}

void addFacts(Class& tables) {
  tables
      .def_property_readonly(
          "levels", [](const Tables& own) { return own.info().level_count; },
          "The last level: more than asked for where half-box converts a mesh in a step of its own.")
      .def_property_readonly(
          "normals", [](const Tables& own) { return kNormals.at(static_cast<std::size_t>(own.info().normals)); },
          "Those that evaluators find.")
      .def_property_readonly(
          "tiles", [](const Tables& own) { return own.info().tiles != 0; }, "Are there any?")
      .def_property_readonly(
          "limits", [](const Tables& own) { return own.info().limits != 0; }, "Are there any?")
      .def_property_readonly(
          "control_points", [](const Tables& own) { return own.info().control_points; }, "Points of level 0.")
      .def_property_readonly(
          "nbytes", [](const Tables& own) { return own.info().bytes; }, "Of all arrays.")
      .def("counts", &Tables::counts, py::arg("level") = py::none(), "Of a level; None: the last.");
}

void addIndexBuffers(Class& tables) {
  tables
      .def("faces", faces, py::arg("level") = py::none(),
           "Offsets and vertices, in the tables' own memory: face f of the level (None: the last) is "
           "vertices[offsets[f]:offsets[f + 1]].")
      .def(
          "triangles",
          [](const Tables& own, const Level& level, const std::optional<py::object>& out) {
            return indices(own, level, out, hc_tables_triangles, own.counts(level).triangle_indices, 3);
          },
          py::arg("level") = py::none(), py::arg("out") = py::none(),
          "The faces cut into fans: (n, 3) int32, in `out` where that is given.")
      .def(
          "lines",
          [](const Tables& own, const Level& level, const std::optional<py::object>& out) {
            return indices(own, level, out, hc_tables_lines, own.counts(level).line_indices, 2);
          },
          py::arg("level") = py::none(), py::arg("out") = py::none(),
          "The edges, each once: (n, 2) int32, in `out` where that is given.");
}

void addOrigins(Class& tables) {
  tables
      .def(
          "face_origins",
          [](const Tables& own, const Level& level) {
            return origins(own, level, hc_tables_face_origins, own.counts(level).faces);
          },
          py::arg("level") = py::none(),
          "What each face descends from: number of the control face (kind 2) or vertex (kind 1), and the level it "
          "first "
          "appeared at (-1: of tables of a file).")
      .def(
          "vertex_origins",
          [](const Tables& own, const Level& level) {
            return origins(own, level, hc_tables_vertex_origins, own.counts(level).vertices);
          },
          py::arg("level") = py::none(), "The same of each vertex; tables of a file don't have it.");
}

}  // namespace

hc_tables_info Tables::info() const {
  hc_tables_info info{};
  info.struct_size = sizeof info;
  check(hc_tables_get_info(get(), &info));
  return info;
}

hc_level_counts Tables::counts(const Level& given) const {
  hc_level_counts counts{};
  counts.struct_size = sizeof counts;
  check(hc_tables_get_counts(get(), level(given), &counts));
  return counts;
}

void addTables(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(hc_crease, vertex0, vertex1, sharpness);
  PYBIND11_NUMPY_DTYPE(hc_origin, number, level, kind);
  addCounts(module);
  Class tables(module, "Tables", kTablesText);
  addMaking(tables);
  addFacts(tables);
  addIndexBuffers(tables);
  addOrigins(tables);
}

}  // namespace honeycomb::Python
