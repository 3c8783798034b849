#include <filesystem>

#include "capi/structs.h"
#include "capi/tables.h"
#include "io/table_file.h"

namespace honeycomb::Capi {
namespace {

std::filesystem::path pathOf(const char* path) {
  return reinterpret_cast<const char8_t*>(path);
}

/// Everything proven now, so that no other function meets an error of the file.
Result<OpenedFile> openFile(const char* path, bool trusted) {
  Result<Io::TableFile> file =
      Io::TableFile::open(pathOf(path), trusted ? Io::TableFile::Trust::file : Io::TableFile::Trust::nobody);
  if (!file) return tl::unexpected(file.error());
  const Result<Far::LevelTables> levels = file->levels();
  if (!levels) return tl::unexpected(levels.error());
  const Result<const Far::TileTable*> tiles = file->tiles();
  if (!tiles) return tl::unexpected(tiles.error());
  const Result<Io::TableMesh> mesh = file->mesh();
  if (!mesh) return tl::unexpected(mesh.error());
  return OpenedFile{std::move(*file), *levels, *tiles, *mesh};
}

/// The normals that evaluators can find: those that the tiles were built with,
/// else limits.
hc_normals normalsOf(const OpenedFile& opened) {
  const auto kind = opened.tiles != nullptr ? opened.tiles->normalKind : Far::TileNormalKind::none;
  if (kind == Far::TileNormalKind::fast) return HC_NORMALS_FAST;
  const bool exact = opened.file.hasLimits() && (opened.tiles == nullptr || kind == Far::TileNormalKind::exact);
  return exact ? HC_NORMALS_EXACT : HC_NORMALS_NONE;
}

Result<void> checkPath(const char* path) {
  if (path == nullptr) return refuse("path is NULL; name a file");
  return {};
}

Result<hc_tables*> openTables(const ContextHandle& context, const char* path, const hc_open_options* given) {
  const Result<hc_open_options> options = readStruct(given, "hc_open_options");
  if (!options) return tl::unexpected(options.error());
  Result<OpenedFile> opened = openFile(path, options->trusted != 0);
  if (!opened) return tl::unexpected(opened.error());
  const hc_normals normals = normalsOf(*opened);
  Io::TableInfo info = opened->file.info();
  return make<hc_tables>(context, std::nullopt, std::move(*opened), normals, std::nullopt, std::nullopt,
                         std::move(info));
}

}  // namespace
}  // namespace honeycomb::Capi

using namespace honeycomb;

hc_status hc_tables_open(hc_context* context, const char* path, const hc_open_options* options, hc_tables** tables) {
  return Capi::guarded(context != nullptr ? context->context.get() : nullptr, [&]() -> Result<void> {
    if (auto named = Capi::checkPath(path); !named) return named;
    if (tables == nullptr) return Capi::refuse("tables is NULL; say where the new tables go");
    const Result<hc_tables*> made = Capi::openTables(Capi::contextOf(context), path, options);
    if (!made) return tl::unexpected(made.error());
    *tables = *made;
    return {};
  });
}

hc_status hc_tables_save(const hc_tables* tables, const char* path) {
  return Capi::guarded(Capi::contextIn(tables), [&]() -> Result<void> {
    if (auto there = Capi::checkLevel(tables, 0); !there) return there;
    if (auto named = Capi::checkPath(path); !named) return named;
    if (tables->file) return Capi::refuse("these tables are in a file already; copy that");
    return Io::writeTableFile(Capi::pathOf(path), {*tables->refinement, tables->tileTable(), tables->info});
  });
}
