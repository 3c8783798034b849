#include "tests/support/golden_chain.h"

#include <set>

#include "far/schemes/centroid.h"
#include "far/schemes/doo_sabin.h"
#include "far/schemes/half_box.h"
#include "far/schemes/midpoint.h"
#include "far/schemes/trisect.h"
#include "far/schemes/zhang_wang.h"
#include "tests/support/must.h"
#include "tests/support/refined.h"

namespace honeycomb::Test {
namespace {

Far::ZhangWangOptions zhangWangOptions(const std::string& folder) {
  Far::ZhangWangOptions options;
  if (folder == "zhang-wang-kobbelt-c0.25") {
    options.pull.rule = Far::CentralPull::Rule::kobbelt;
    options.vertexPull = 0.25;
  } else if (folder == "zhang-wang-alpha0.3-c1") {
    options.alpha = 0.3;
    options.vertexPull = 1;
  } else if (folder == "zhang-wang-brick") {
    options.boundary = Far::BoundaryRule::brick;
  }
  return options;
}

Far::HalfBoxOptions halfBoxOptions(const std::string& folder) {
  Far::HalfBoxOptions options;
  if (folder == "halfbox-clamped") options.boundary = Far::HalfBoxBoundary::clamped;
  if (folder == "halfbox-trisect") options.conversion = Far::HalfBoxConversion::trisect;
  if (folder == "halfbox-tuned-all") options.tuning = Far::HalfBoxTuning::all;
  if (folder == "halfbox-tuned-first") options.tuning = Far::HalfBoxTuning::first;
  return options;
}

Far::Scheme oneScheme(const std::string& folder) {
  if (folder == "midpoint") return Far::midpoint();
  if (folder == "trisect") return must(Far::trisect());
  if (folder == "centroid") return Far::centroid();
  if (folder == "doo-sabin") return Far::dooSabin();
  return goldenScheme(folder).scheme;
}

}  // namespace

bool isRefinedByScheme(const std::string& folder) {
  return !std::set<std::string>{"dual", "triangulate", "quads"}.contains(folder);
}

std::vector<Far::Scheme> goldenChain(const std::string& folder, const Far::Topology& control, std::int32_t level) {
  if (folder.starts_with("zhang-wang")) return must(Far::zhangWang(control, level, zhangWangOptions(folder)));
  if (folder.starts_with("halfbox")) return must(Far::halfBox(control, level, halfBoxOptions(folder)));
  return std::vector<Far::Scheme>(static_cast<std::size_t>(level), oneScheme(folder));
}

}  // namespace honeycomb::Test
