#include "chain/scheme_chain.h"

#include <fmt/format.h>

#include <array>
#include <charconv>

#include "chain/choice.h"
#include "chain/words.h"
#include "far/base/index.h"
#include "far/tables/refinement.h"
#include "far/topology/defects.h"

namespace honeycomb::Chain {
namespace {

struct CornerChoice {
  std::string_view name;
  bool keep;
};
constexpr std::array kCorners{CornerChoice{"none", false}, CornerChoice{"valence2", true}};

/// "akleman:1"
Result<ChainPart> readPart(const std::string& scheme, std::string_view word) {
  const std::size_t colon = word.find(':');
  if (word.substr(0, colon).empty())
    return fail(ErrorCode::invalidOption,
                fmt::format("--scheme {}: a chain is written NAME:LEVELS,NAME:LEVELS; a name is missing", scheme));
  const auto entry = choose(schemes(), "--scheme", word.substr(0, colon));
  if (!entry) return tl::unexpected(entry.error());
  ChainPart part{*entry, 0, {}};
  const std::string_view count = colon == std::string_view::npos ? "" : word.substr(colon + 1);
  const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), part.levels);
  const bool whole = error == std::errc() && end == count.data() + count.size();
  if (!whole || part.levels < 1 || part.levels > Far::kMaxLevels)
    return fail(ErrorCode::invalidOption,
                fmt::format("--scheme {}: '{}' must say how many levels, from 1 to {}, as in {}:1", scheme, word,
                            Far::kMaxLevels, (*entry)->name));
  return part;
}

Result<ChainRequest> readParts(const std::string& scheme, std::optional<std::int32_t> levels) {
  ChainRequest request;
  for (const std::string_view word : commaSeparated(scheme)) {
    const Result<ChainPart> part = readPart(scheme, word);
    if (!part) return tl::unexpected(part.error());
    request.parts.push_back(*part);
    request.levels += part->levels;
  }
  if (request.levels > Far::kMaxLevels)
    return fail(ErrorCode::invalidOption, fmt::format("--scheme {}: has {} levels, {} is the most; use fewer", scheme,
                                                      request.levels, Far::kMaxLevels));
  if (levels && *levels != request.levels)
    return fail(ErrorCode::invalidOption,
                fmt::format("--levels {}: the chain {} has {}; leave --levels out", *levels, scheme, request.levels));
  return request;
}

Result<ChainRequest> readName(const std::string& scheme, std::int32_t levels, std::int32_t least) {
  const auto entry = choose(schemes(), "--scheme", scheme);
  if (!entry) return tl::unexpected(entry.error());
  if (levels < least || levels > Far::kMaxLevels)
    return fail(ErrorCode::invalidOption,
                fmt::format("--levels {}: give a number from {} to {}", levels, least, Far::kMaxLevels));
  return ChainRequest{{{*entry, levels, {}}}, levels};
}

/// Options must mean something to a scheme of the chain.
Result<void> checkOwners(const ChainRequest& request, const SchemeOptions& options) {
  for (const SchemeEntry& entry : schemes()) {
    for (const SchemeOption* option : entry.options) {
      if (!options.given(*option)) continue;
      const auto has = [&](const ChainPart& part) { return part.scheme->has(*option); };
      if (std::any_of(request.parts.begin(), request.parts.end(), has)) continue;
      return fail(ErrorCode::invalidOption,
                  fmt::format("{}: {} has no such option, only {}; leave it out, or choose another --scheme",
                              option->name, options.scheme, ownersOf(*option)));
    }
  }
  return {};
}

std::string boundaryList(std::span<const std::string_view> boundaries) {
  return fmt::format("{}", fmt::join(boundaries, ", "));
}

/// Each scheme takes the rule that was named if it has it, else its own default, or brick behind a scheme with brick,
/// whose cut faces only brick can refine; one of them must have a rule that was named.
Result<void> chooseBoundaries(ChainRequest& request, const SchemeOptions& options) {
  const std::string named = options.text(kBoundaryOption);
  bool taken = !options.given(kBoundaryOption);
  std::string choices;
  bool cut = false;
  for (ChainPart& part : request.parts) {
    const auto boundaries = part.scheme->boundaries;
    if (boundaries.empty()) continue;
    const auto find = [&](std::string_view rule) { return std::find(boundaries.begin(), boundaries.end(), rule); };
    const bool has = options.given(kBoundaryOption) && find(named) != boundaries.end();
    part.boundary = has ? *find(named) : cut && find("brick") != boundaries.end() ? "brick" : boundaries.front();
    cut = part.boundary == "brick";
    taken = taken || has;
    choices += fmt::format("{}{} has {}", choices.empty() ? "" : "; ", part.scheme->name, boundaryList(boundaries));
  }
  if (taken) return {};
  return fail(ErrorCode::invalidOption, fmt::format("--boundary: there is no '{}' here; {}", named, choices));
}

bool usesBoundary(const ChainRequest& request, std::string_view boundary) {
  return std::any_of(request.parts.begin(), request.parts.end(),
                     [&](const ChainPart& part) { return part.boundary == boundary; });
}

/// Options that only one boundary rule looks at.
Result<void> checkBoundaryOptions(const ChainRequest& request, const SchemeOptions& options) {
  const std::string corners = options.text(kCornersOption);
  const auto choice = choose(kCorners, kCornersOption.name, corners);
  if (!choice) return tl::unexpected(choice.error());
  const ChainPart& first = request.parts.front();
  const bool ruleKeeps = first.boundary == "brick" || (first.boundary.empty() && first.scheme->has(kCornersOption));
  if ((*choice)->keep && !ruleKeeps)
    return fail(ErrorCode::invalidOption,
                fmt::format("--corners {}: {} keeps none{}; only the brick boundary at the first level does", corners,
                            first.scheme->name,
                            first.boundary.empty() ? "" : fmt::format(" with --boundary {}", first.boundary)));
  if (options.given(kBoundaryWeightOption) && !usesBoundary(request, "eq16"))
    return fail(ErrorCode::invalidOption,
                fmt::format("--sn {}: only the eq16 boundary has this weight; add --boundary eq16",
                            *options.number(kBoundaryWeightOption)));
  return {};
}

Result<void> checkCentral(const ChainRequest& request, const SchemeOptions& options) {
  const bool file = options.given(kCentralFileOption), offset = options.given(kCentralOffsetOption);
  if (file && offset)
    return fail(ErrorCode::invalidOption,
                "--ccv-offset: --ccv already says where all central control vertices are; "
                "leave one of them out");
  if ((file || offset) && !request.parts.front().scheme->centralPoints)
    return fail(
        ErrorCode::invalidOption,
        fmt::format("{}: central control vertices belong to the faces of IN, so the first scheme of the chain "
                    "must have them, and {} hasn't; leave it out, or begin with zhang-wang",
                    file ? kCentralFileOption.name : kCentralOffsetOption.name, request.parts.front().scheme->name));
  return {};
}

/// The mesh that the steps so far make, for schemes that look at theirs.
Result<Far::Topology> applySteps(const SchemeChain& chain, const Far::Topology& control, const ChainCheck& fits) {
  if (const auto fit = fits(control, chain); !fit) return tl::unexpected(fit.error());
  Far::Topology mesh = control;
  for (const Far::Scheme& step : chain.steps) {
    Result<Far::SplitResult> split = step.split.apply(mesh);
    if (!split) return tl::unexpected(split.error());
    mesh = std::move(split->topology);
  }
  return mesh;
}

void append(SchemeChain& chain, std::vector<Far::Scheme> steps, std::int32_t levels) {
  const auto conversions = static_cast<std::int32_t>(steps.size()) - levels;
  const std::int32_t before = chain.levels();
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(steps.size()); ++i)
    chain.levelOf.push_back(before + std::max(0, i + 1 - conversions));
  std::move(steps.begin(), steps.end(), std::back_inserter(chain.steps));
}

/// Options that are out of range with the scheme they belong to, elements with the level: those of refined meshes mean
/// nothing to the owner of the control mesh.
Error ofPart(const SchemeChain& chain, const ChainPart& part, Error error) {
  const bool option = error.code == ErrorCode::invalidOption && error.kind == ElementKind::other;
  if (option && !error.message.starts_with("--"))
    error.message = fmt::format("--scheme {}: {}", part.scheme->name, error.message);
  if (option || chain.steps.empty()) return error;
  return {error.code, fmt::format("level {}: {}", chain.levels(), error.message)};
}

}  // namespace

Result<ChainRequest> readChain(const SchemeOptions& options, std::optional<std::int32_t> levels,
                               const LevelChoice& choice) {
  const bool chain = options.scheme.find_first_of(",:") != std::string::npos;
  Result<ChainRequest> request =
      chain ? readParts(options.scheme, levels) : readName(options.scheme, levels.value_or(choice.usual), choice.least);
  if (!request) return request;
  Result<void> sound = checkOwners(*request, options);
  if (sound) sound = chooseBoundaries(*request, options);
  if (sound) sound = checkBoundaryOptions(*request, options);
  if (sound) sound = checkCentral(*request, options);
  if (!sound) return tl::unexpected(sound.error());
  return request;
}

Result<SchemeChain> makeChain(const ChainRequest& request, const SchemeOptions& options, const Far::Topology& control,
                              const ChainCheck& fits) {
  SchemeChain chain;
  for (const ChainPart& part : request.parts) {
    Result<Far::Topology> refined = Far::Topology();
    if (!chain.steps.empty() && part.scheme->looksAtMesh) refined = applySteps(chain, control, fits);
    if (!refined) return tl::unexpected(ofPart(chain, part, refined.error()));
    const Far::Topology& mesh = chain.steps.empty() ? control : *refined;
    Result<std::vector<Far::Scheme>> steps = part.scheme->make({options, mesh, part.levels, part.boundary});
    if (!steps) return tl::unexpected(ofPart(chain, part, steps.error()));
    append(chain, std::move(*steps), part.levels);
  }
  return chain;
}

void tagCorners(const SchemeOptions& options, Far::Polygons& polygons) {
  const auto choice = choose(kCorners, kCornersOption.name, options.text(kCornersOption));
  if (!choice || !(*choice)->keep) return;
  const std::vector<std::int32_t> corners = Far::cornersPerVertex(polygons);
  for (std::int32_t v = 0; v < polygons.vertexCount; ++v)
    if (corners[at(v)] == 1) polygons.corners.push_back(v);
}

std::vector<std::string> stepNames(const SchemeChain& chain) {
  std::vector<std::string> stepsByName;
  for (const Far::Scheme& step : chain.steps) stepsByName.push_back(step.name);
  return stepsByName;
}

}  // namespace honeycomb::Chain
