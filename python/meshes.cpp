#include <filesystem>

#include "io/mesh_output.h"
#include "python/arrays.h"
#include "python/failure.h"
#include "python/tables.h"

namespace honeycomb::Python {
namespace {

/// Points, face_offsets, face_vertices, creases and corners, in memory that they share.
py::tuple readMesh(const std::filesystem::path& path) {
  hc_mesh* mesh = nullptr;
  unlocked([&] { return hc_mesh_read(nullptr, path.c_str(), &mesh); });
  const py::capsule owner(mesh, [](void* own) { hc_mesh_destroy(static_cast<hc_mesh*>(own)); });
  hc_polygons polygons{};
  polygons.struct_size = sizeof polygons;
  check(hc_mesh_polygons(mesh, &polygons));
  const float* positions = nullptr;
  check(hc_mesh_positions(mesh, &positions, nullptr));
  return py::make_tuple(viewOf(positions, {polygons.vertex_count, 3}, owner),
                        viewOf(polygons.face_offsets, {polygons.face_count + 1}, owner),
                        viewOf(polygons.face_vertices, {polygons.face_vertex_count}, owner),
                        viewOf(polygons.creases, {polygons.crease_count}, owner),
                        viewOf(polygons.corners, {polygons.corner_count}, owner));
}

void writeMesh(const std::filesystem::path& path, const Tables& tables, const py::object& points,
               const std::optional<py::object>& normals, const std::optional<std::int32_t>& level) {
  const hc_level_counts counts = tables.counts(level);
  const std::int32_t* offsets = nullptr;
  const std::int32_t* vertices = nullptr;
  check(hc_tables_faces(tables.get(), tables.level(level), &offsets, &vertices));
  Io::ObjContent<float> content;
  content.positions = packedPointsOf(points, "points", counts.vertices);
  if (normals) content.normals = packedPointsOf(*normals, "normals", counts.vertices);
  content.faceOffsets = {offsets, static_cast<std::size_t>(counts.faces + 1)};
  content.faceVertices = {vertices, static_cast<std::size_t>(counts.corners)};
  unlockedResult([&]() -> Result<void> {
    const Result<const Io::MeshOutput*> format = Io::meshOutput(path);
    if (!format) return tl::unexpected(format.error());
    return (*format)->write(path, content);
  });
}

}  // namespace

void addMeshes(py::module_& module) {
  module.attr("crease") = py::dtype::of<hc_crease>();
  module.def("read_mesh", readMesh, py::arg("path"), "What Mesh.read() makes a Mesh of.");
  module.def(
      "write_mesh", writeMesh, py::arg("path"), py::arg("tables"), py::arg("points"), py::arg("normals") = py::none(),
      py::arg("level") = py::none(),
      "Writes a level (None: the last) as OBJ, PLY or GLB, by the path's extension, whole or not at all; points and "
      "normals: (vertices, 3) float32, packed. Raises TypeError, ValueError, Error.");
}

}  // namespace honeycomb::Python
