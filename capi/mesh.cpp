#include <cmath>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "capi/structs.h"
#include "io/mesh_formats.h"

struct hc_mesh {
  honeycomb::Capi::ContextHandle context;
  honeycomb::Far::Polygons polygons;
  std::vector<hc_crease> creases;
  std::vector<float> positions;
};

namespace honeycomb::Capi {
namespace {

Result<std::vector<float>> inSinglePrecision(const std::vector<double>& positions) {
  std::vector<float> result;
  result.reserve(positions.size());
  for (const double coordinate : positions) {
    result.push_back(static_cast<float>(coordinate));
    const auto vertex = static_cast<std::int64_t>((result.size() - 1) / 3);
    if (!std::isfinite(result.back()))
      return fail(
          ErrorCode::invalidPositions,
          fmt::format("{} overflows single precision; scale the mesh down", elementName(ElementKind::vertex, vertex)),
          vertex, ElementKind::vertex);
  }
  return result;
}

Result<hc_mesh*> readMesh(const ContextHandle& context, const char* path) {
  // Paths are bytes on this side, UTF-8 on all.
  const std::filesystem::path file(reinterpret_cast<const char8_t*>(path));
  std::vector<std::string> notes;
  Result<Io::Mesh> mesh = Io::readAnyMesh(file, notes);
  if (!mesh) return tl::unexpected(mesh.error());
  Result<std::vector<float>> positions = inSinglePrecision(mesh->positions);
  if (!positions) return tl::unexpected(positions.error());
  std::vector<hc_crease> creases;
  for (const Far::Crease& crease : mesh->polygons.creases)
    creases.push_back({crease.vertex0, crease.vertex1, crease.sharpness});
  for (const std::string& note : notes) context->say(HC_LOG_NOTE, fmt::format("{}: {}", path, note).c_str());
  return make<hc_mesh>(context, std::move(mesh->polygons), std::move(creases), std::move(*positions));
}

const Context* contextOfMesh(const hc_mesh* mesh) {
  return mesh != nullptr ? mesh->context.get() : nullptr;
}

Result<void> checkMesh(const hc_mesh* mesh) {
  if (mesh == nullptr) return refuse("mesh is NULL; give one of hc_mesh_read()");
  return {};
}

}  // namespace
}  // namespace honeycomb::Capi

using namespace honeycomb;

hc_status hc_mesh_read(hc_context* context, const char* path, hc_mesh** mesh) {
  return Capi::guarded(context != nullptr ? context->context.get() : nullptr, [&]() -> Result<void> {
    if (path == nullptr) return Capi::refuse("path is NULL; name a file");
    if (mesh == nullptr) return Capi::refuse("mesh is NULL; say where the new mesh goes");
    const Result<hc_mesh*> made = Capi::readMesh(Capi::contextOf(context), path);
    if (!made) return tl::unexpected(made.error());
    *mesh = *made;
    return {};
  });
}

void hc_mesh_destroy(hc_mesh* mesh) {
  Capi::destroy(mesh);
}

hc_status hc_mesh_polygons(const hc_mesh* mesh, hc_polygons* polygons) {
  return Capi::guarded(Capi::contextOfMesh(mesh), [&]() -> Result<void> {
    if (auto there = Capi::checkMesh(mesh); !there) return there;
    const Far::Polygons& own = mesh->polygons;
    hc_polygons view{};
    view.vertex_count = own.vertexCount;
    view.face_count = own.faceCount();
    view.face_offsets = own.faceOffsets.data();
    view.face_vertices = own.indices.data();
    view.face_vertex_count = std::ssize(own.indices);
    view.creases = mesh->creases.empty() ? nullptr : mesh->creases.data();
    view.crease_count = std::ssize(mesh->creases);
    view.corners = own.corners.empty() ? nullptr : own.corners.data();
    view.corner_count = std::ssize(own.corners);
    return Capi::writeStruct(view, polygons, "hc_polygons");
  });
}

hc_status hc_mesh_positions(const hc_mesh* mesh, const float** positions, size_t* count) {
  return Capi::guarded(Capi::contextOfMesh(mesh), [&]() -> Result<void> {
    if (auto there = Capi::checkMesh(mesh); !there) return there;
    if (positions == nullptr) return Capi::refuse("positions is NULL; say where the pointer goes");
    *positions = mesh->positions.data();
    if (count != nullptr) *count = mesh->positions.size();
    return {};
  });
}
