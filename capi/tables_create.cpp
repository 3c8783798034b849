#include <string>

#include "capi/polygons.h"
#include "capi/structs.h"
#include "capi/tables.h"
#include "chain/scheme_chain.h"
#include "osd/tile_size.h"

namespace honeycomb::Capi {
namespace {

Result<void> checkOptions(const hc_tables_options& options) {
  if (options.levels < 0) return refuse(fmt::format("levels is {}; give 1 or more, or 0 for 2", options.levels));
  if (options.option_count > 0 && options.options == nullptr)
    return refuse(fmt::format("options is NULL; give its {} entries", options.option_count));
  if (options.normals < HC_NORMALS_NONE || options.normals > HC_NORMALS_EXACT)
    return refuse(fmt::format("normals is {}; give one of hc_normals", options.normals));
  if (options.order != HC_ORDER_INPUT && options.order != HC_ORDER_SPATIAL)
    return refuse(fmt::format("order is {}; give one of hc_order", options.order));
  if (options.memory_limit < 0)
    return refuse(fmt::format("memory_limit is {}; give bytes, or 0 for no limit", options.memory_limit));
  return {};
}

/// What the command line would have read behind --scheme.
Result<Chain::SchemeOptions> readScheme(const hc_tables_options& options) {
  Chain::SchemeOptions scheme;
  if (options.scheme != nullptr) scheme.scheme = options.scheme;
  for (std::size_t i = 0; i < options.option_count; ++i) {
    const hc_option& option = options.options[i];
    if (option.name == nullptr) return refuse(fmt::format("the name of option {} is NULL; give one", i));
    const auto set = scheme.set(std::string_view(option.name), option.value == nullptr ? "" : option.value);
    if (!set) return tl::unexpected(set.error());
  }
  for (const Chain::SchemeOption* file : {&Chain::kCentralFileOption, &Chain::kCentralOffsetOption})
    if (scheme.given(*file))
      return refuse(
          fmt::format("{}: belongs to the command line; set central_points, and give central control vertices "
                      "as points behind the vertices",
                      file->name));
  return scheme;
}

Result<void> checkMemory(const Far::Topology& control, const Chain::SchemeChain& chain, std::int64_t limit) {
  const Far::BuildBytes build = Far::buildBytes(Far::predict(control, chain.steps), false);
  if (limit == 0 || build.tables + build.scratch <= limit) return {};
  return fail(ErrorCode::tooLarge,
              fmt::format("{} levels would take about {} bytes, memory_limit is {}; use fewer levels", chain.levels(),
                          build.tables + build.scratch, limit));
}

Result<Chain::SchemeChain> chooseSteps(const hc_tables_options& options, const Chain::SchemeOptions& scheme,
                                       const Chain::ChainRequest& request, const Far::Topology& control) {
  const auto& first = *request.parts.front().scheme;
  if (options.central_points != 0 && !first.centralPoints)
    return refuse(
        fmt::format("central_points: {} has no central control vertices; leave them out, or begin with a "
                    "scheme that has them, such as zhang-wang",
                    first.name));
  const auto& last = *request.parts.back().scheme;
  if ((options.limits != 0 || options.normals == HC_NORMALS_EXACT) && !last.limits)
    return refuse(
        fmt::format("limits and exact normals of a chain that ends with {} are not known; end it with "
                    "another scheme, or leave them out",
                    last.name));
  return Chain::makeChain(request, scheme, control, [&](const Far::Topology& mesh, const Chain::SchemeChain& chain) {
    return checkMemory(mesh, chain, options.memory_limit);
  });
}

/// What evaluators want besides the levels.
Result<void> addNormals(hc_tables& tables, const hc_tables_options& options) {
  if (options.normals == HC_NORMALS_FAST) {
    Result<Far::NormalTable> normals = Far::buildNormalTable(*tables.refinement, tables.levelCount());
    if (!normals) return tl::unexpected(normals.error());
    tables.fastNormals = std::move(*normals);
  }
  if (options.tiles == 0) return {};
  const auto normals = options.normals == HC_NORMALS_FAST    ? Far::TileNormalKind::fast
                       : options.normals == HC_NORMALS_EXACT ? Far::TileNormalKind::exact
                                                             : Far::TileNormalKind::none;
  Result<Far::TileTable> tiles = Far::buildTileTable(*tables.refinement, Osd::cpuTileOptions(normals));
  if (!tiles) {
    tiles.error().message += " (or set tiles to 0)";
    return tl::unexpected(tiles.error());
  }
  tables.tiles = std::move(*tiles);
  return {};
}

void noteConversion(const Context& context, const Chain::SchemeChain& chain) {
  const auto more = static_cast<std::int64_t>(chain.steps.size()) - chain.levels();
  if (more > 0)
    context.say(HC_LOG_NOTE, fmt::format("{} of {} levels convert the mesh to one that the scheme can refine", more,
                                         chain.steps.size())
                                 .c_str());
}

/// What a table file says of its making.
Io::TableInfo infoOf(const Far::Polygons& polygons, const Chain::SchemeChain& chain) {
  return {Io::meshHash(polygons),
          polygons.vertexCount,
          static_cast<std::int32_t>(polygons.faceCount()),
          Chain::stepNames(chain),
          {}};
}

Result<hc_tables*> createTables(const ContextHandle& context, const hc_polygons* mesh, const hc_tables_options* given) {
  const Result<hc_tables_options> options = readStruct(given, "hc_tables_options");
  if (!options) return tl::unexpected(options.error());
  if (const auto sound = checkOptions(*options); !sound) return tl::unexpected(sound.error());
  const Result<Chain::SchemeOptions> scheme = readScheme(*options);
  if (!scheme) return tl::unexpected(scheme.error());
  const Result<Chain::ChainRequest> request =
      Chain::readChain(*scheme, options->levels == 0 ? std::nullopt : std::optional(options->levels));
  if (!request) return tl::unexpected(request.error());

  Result<Far::Polygons> polygons = readPolygons(mesh);
  if (!polygons) return tl::unexpected(polygons.error());
  Chain::tagCorners(*scheme, *polygons);
  const Result<Far::Topology> control = Far::Topology::create(
      *polygons, options->order == HC_ORDER_SPATIAL ? Far::FaceOrder::spatial : Far::FaceOrder::input);
  if (!control) return tl::unexpected(control.error());
  const Result<Chain::SchemeChain> chain = chooseSteps(*options, *scheme, *request, *control);
  if (!chain) return tl::unexpected(chain.error());
  const bool limits = options->limits != 0 || options->normals == HC_NORMALS_EXACT;
  Result<Far::Refinement> refinement =
      Far::refine(*control, chain->steps, {options->central_points != 0, limits, options->memory_limit});
  if (!refinement) return tl::unexpected(refinement.error());
  hc_tables tables{context, std::move(*refinement), {}, options->normals, {}, {}, infoOf(*polygons, *chain)};
  if (const auto added = addNormals(tables, *options); !added) return tl::unexpected(added.error());
  noteConversion(*context, *chain);
  return make<hc_tables>(context, std::move(tables.refinement), std::nullopt, tables.normals, std::move(tables.tiles),
                         std::move(tables.fastNormals), std::move(tables.info));
}

}  // namespace
}  // namespace honeycomb::Capi

using namespace honeycomb;

hc_status hc_tables_create(hc_context* context, const hc_polygons* polygons, const hc_tables_options* options,
                           hc_tables** tables) {
  return Capi::guarded(context != nullptr ? context->context.get() : nullptr, [&]() -> Result<void> {
    if (tables == nullptr) return Capi::refuse("tables is NULL; say where the new tables go");
    const Result<hc_tables*> made = Capi::createTables(Capi::contextOf(context), polygons, options);
    if (!made) return tl::unexpected(made.error());
    *tables = *made;
    return {};
  });
}

void hc_tables_destroy(hc_tables* tables) {
  Capi::destroy(tables);
}
