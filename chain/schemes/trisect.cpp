#include "far/schemes/trisect.h"

#include <array>

#include "chain/schemes.h"

namespace honeycomb::Chain {
namespace {

constexpr SchemeOption kRatio{"--ratio", SchemeOption::Kind::number, "1/3",
                              "How far along its edge a point lies from the vertex it is next to, in (0, 1/2)"};

Result<std::vector<Far::Scheme>> make(const SchemeRequest& request) {
  Far::TrisectOptions trisect;
  trisect.ratio = request.options.number(kRatio).value_or(trisect.ratio);
  return Far::trisect(trisect).map(
      [&](const Far::Scheme& step) { return std::vector(static_cast<std::size_t>(request.levels), step); });
}

constexpr std::array kOptions{&kRatio};

}  // namespace

const SchemeEntry kTrisect{"trisect", make, kOptions};

}  // namespace honeycomb::Chain
