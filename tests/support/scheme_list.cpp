#include "tests/support/scheme_list.h"

#include <stdexcept>

#include "far/schemes/akleman.h"
#include "far/schemes/centroid.h"
#include "far/schemes/doo_sabin.h"
#include "far/schemes/half_box.h"
#include "far/schemes/midpoint.h"
#include "far/schemes/trisect.h"
#include "far/schemes/zhang_wang.h"

namespace honeycomb::Test {
namespace {

using Chain = Result<std::vector<Far::Scheme>>;

ListedScheme repeated(std::string name, Result<Far::Scheme> scheme, bool threeEdges = false) {
  return {std::move(name),
          [scheme = std::move(scheme)](const Far::Topology&, std::int32_t levels) -> Chain {
            if (!scheme) return tl::unexpected(scheme.error());
            return std::vector<Far::Scheme>(static_cast<std::size_t>(levels), *scheme);
          },
          threeEdges};
}

ListedScheme zhangWang(std::string name, Far::ZhangWangOptions options) {
  return {std::move(name), [options = std::move(options)](const Far::Topology& control, std::int32_t levels) {
            return Far::zhangWang(control, levels, options);
          }};
}

ListedScheme halfBox(std::string name, const Far::HalfBoxOptions& options) {
  return {
      std::move(name),
      [options](const Far::Topology& control, std::int32_t levels) { return Far::halfBox(control, levels, options); },
      options.conversion == Far::HalfBoxConversion::trisect};
}

std::vector<ListedScheme> makeList() {
  const auto boundary = [](Far::BoundaryRule rule) {
    Far::AklemanOptions options;
    options.boundary = rule;
    return Far::akleman(options);
  };
  const auto pull = [](Far::CentralPull::Rule rule, double vertexPull, Far::BoundaryRule borders) {
    Far::ZhangWangOptions options;
    options.pull.rule = rule;
    options.vertexPull = vertexPull;
    options.boundary = borders;
    return options;
  };
  const auto tuned = [](Far::HalfBoxTuning tuning, Far::HalfBoxConversion conversion) {
    Far::HalfBoxOptions options;
    options.tuning = tuning;
    options.conversion = conversion;
    return options;
  };
  return {repeated("akleman brick", boundary(Far::BoundaryRule::brick)),
          repeated("akleman eq16", boundary(Far::BoundaryRule::eq16)),
          zhangWang("zhang-wang eq16", pull(Far::CentralPull::Rule::paper, 0.5, Far::BoundaryRule::eq16)),
          zhangWang("zhang-wang brick", pull(Far::CentralPull::Rule::kobbelt, 0.25, Far::BoundaryRule::brick)),
          halfBox("half-box", tuned(Far::HalfBoxTuning::none, Far::HalfBoxConversion::automatic)),
          halfBox("half-box tuned first", tuned(Far::HalfBoxTuning::first, Far::HalfBoxConversion::akleman)),
          halfBox("half-box tuned all", tuned(Far::HalfBoxTuning::all, Far::HalfBoxConversion::trisect)),
          repeated("midpoint", Far::midpoint(), true),
          repeated("trisect", Far::trisect({.ratio = 0.25}), true),
          repeated("centroid", Far::centroid(), true),
          repeated("doo-sabin", Far::dooSabin(), true)};
}

}  // namespace

const std::vector<ListedScheme>& listedSchemes() {
  static const std::vector<ListedScheme> list = makeList();
  return list;
}

bool hasTwoValentVertex(const Far::Topology& topology) {
  for (std::int32_t v = 0; v < topology.vertexCount(); ++v) {
    if (!topology.onBoundary(v) && topology.facesAt(v) < 3) return true;
  }
  return false;
}

Far::Refinement refinedBy(const ListedScheme& scheme, const Far::Topology& control, std::int32_t levels, bool limits) {
  const Chain chain = scheme.chain(control, levels);
  if (!chain) throw std::runtime_error(scheme.name + ": " + chain.error().message);
  Far::RefineOptions options;
  options.limits = limits;
  Result<Far::Refinement> refinement = Far::refine(control, *chain, options);
  if (!refinement) throw std::runtime_error(scheme.name + ": " + refinement.error().message);
  return std::move(*refinement);
}

}  // namespace honeycomb::Test
