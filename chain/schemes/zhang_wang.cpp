#include "far/schemes/zhang_wang.h"

#include <array>

#include "chain/choice.h"
#include "chain/schemes.h"

namespace honeycomb::Chain {

const SchemeOption kCentralFileOption{
    "--ccv", SchemeOption::Kind::text, "",
    "Central control vertices, one a face in file order: the v lines of an OBJ, for bake a PC2 (default: barycentres)"};
const SchemeOption kCentralOffsetOption{"--ccv-offset", SchemeOption::Kind::text, "0",
                                        "Central control vertices at this distance from the barycentres, along the "
                                        "normals of the faces, in units of the mesh: a number, or a file with one a "
                                        "face, each on a line, in file order"};

namespace {

constexpr SchemeOption kAn{
    "--an", SchemeOption::Kind::text, "paper",
    "How far a central control vertex moves to the barycentre in a step: paper, kobbelt, or a number in [0, 1]"};
constexpr SchemeOption kBn{"--bn", SchemeOption::Kind::number, "2/3",
                           "How far corner points lie from the central control vertex, in (0, 1)"};
constexpr SchemeOption kCn{
    "--cn", SchemeOption::Kind::number, "0.5",
    "How far the central control vertex of a vertex's face moves to the points round the vertex, in [0, 1]"};
constexpr SchemeOption kAlpha{
    "--alpha", SchemeOption::Kind::number, "",
    "Share of the neighbours in that, in [0, 1], the rest being the faces' (default: all points alike)"};
constexpr SchemeOption kForce{"--force", SchemeOption::Kind::flag, "",
                              "Take --an and --bn whose surface has no tangent plane"};
constexpr SchemeOption kInterpolate{
    "--interpolate", SchemeOption::Kind::text, "none",
    "What the limit surface is to pass through: none, vertices (all control vertices inside)"};

struct Pull {
  std::string_view name;
  Far::CentralPull::Rule rule;
};
constexpr std::array kPulls{Pull{"paper", Far::CentralPull::Rule::paper},
                            Pull{"kobbelt", Far::CentralPull::Rule::kobbelt}};

struct Interpolation {
  std::string_view name;
  bool vertices;
};
constexpr std::array kInterpolations{Interpolation{"none", false}, Interpolation{"vertices", true}};

Result<Far::CentralPull> parsePull(const std::string& text) {
  if (const auto number = parseNumber(text)) return Far::CentralPull{Far::CentralPull::Rule::constant, *number};
  const auto named = choose(kPulls, kAn.name, text);
  if (!named) return fail(ErrorCode::invalidOption, named.error().message + ", or give a number from 0 to 1");
  return Far::CentralPull{(*named)->rule};
}

std::vector<std::int32_t> verticesInside(const Far::Topology& mesh) {
  std::vector<std::int32_t> inside;
  for (std::int32_t v = 0; v < mesh.vertexCount(); ++v)
    if (!mesh.onBoundary(v)) inside.push_back(v);
  return inside;
}

Result<Far::ZhangWangOptions> readOptions(const SchemeRequest& request) {
  const SchemeOptions& options = request.options;
  const Result<Far::CentralPull> pull = parsePull(options.text(kAn));
  if (!pull) return tl::unexpected(pull.error());
  const auto interpolation = choose(kInterpolations, kInterpolate.name, options.text(kInterpolate));
  if (!interpolation) return tl::unexpected(interpolation.error());
  Far::ZhangWangOptions zhangWang;
  zhangWang.pull = *pull;
  zhangWang.spread = options.number(kBn).value_or(zhangWang.spread);
  zhangWang.vertexPull = options.number(kCn).value_or(zhangWang.vertexPull);
  zhangWang.alpha = options.number(kAlpha);
  zhangWang.boundaryWeight = options.number(kBoundaryWeightOption).value_or(zhangWang.boundaryWeight);
  zhangWang.boundary = zipBoundary(request.boundary);
  zhangWang.unchecked = options.given(kForce);
  if ((*interpolation)->vertices) zhangWang.interpolatedVertices = verticesInside(request.mesh);
  return zhangWang;
}

Result<std::vector<Far::Scheme>> make(const SchemeRequest& request) {
  Result<Far::ZhangWangOptions> options = readOptions(request);
  if (!options) return tl::unexpected(options.error());
  Result<std::vector<Far::Scheme>> steps = Far::zhangWang(request.mesh, request.levels, *options);
  if (steps || options->unchecked) return steps;
  // What is refused now and isn't when unchecked can be forced.
  options->unchecked = true;
  Error error = steps.error();
  if (Far::zhangWang(request.mesh, request.levels, *options)) error.message += " with --force";
  return tl::unexpected(error);
}

constexpr std::array kOptions{&kAn,
                              &kBn,
                              &kCn,
                              &kAlpha,
                              &kBoundaryOption,
                              &kBoundaryWeightOption,
                              &kCornersOption,
                              &kCentralFileOption,
                              &kCentralOffsetOption,
                              &kInterpolate,
                              &kForce};
constexpr std::array<std::string_view, 3> kBoundaries{"eq16", "brick", "drop"};

}  // namespace

const SchemeEntry kZhangWang{"zhang-wang", make, kOptions, kBoundaries, true, true};

}  // namespace honeycomb::Chain
