#include "chain/schemes.h"

#include <array>
#include <charconv>

#include "far/schemes/centroid.h"
#include "far/schemes/doo_sabin.h"
#include "far/schemes/midpoint.h"
#ifdef HONEYCOMB_INTEROP
#include "osd/interop/schemes.h"
#endif

namespace honeycomb::Chain {
namespace {

constexpr std::array kBoundaryOnly{&kBoundaryOption};
constexpr std::array<std::string_view, 1> kDrop{"drop"};

/// A scheme that every level takes alike and that has no options.
template <Far::Scheme (*Step)()>
Result<std::vector<Far::Scheme>> plain(const SchemeRequest& request) {
  return std::vector<Far::Scheme>(static_cast<std::size_t>(request.levels), Step());
}

#ifdef HONEYCOMB_INTEROP
constexpr std::array kCornersOnly{&kCornersOption};

/// A scheme of OpenSubdiv.
template <Far::Scheme (*Step)(const Osd::OpenSubdivOptions&)>
Result<std::vector<Far::Scheme>> foreign(const SchemeRequest& request) {
  return std::vector<Far::Scheme>(static_cast<std::size_t>(request.levels), Step({}));
}
#endif

}  // namespace

std::span<const SchemeEntry> schemes() {
  static const std::array kSchemes{
      kAkleman,
      kZhangWang,
      kHalfBox,
      SchemeEntry{"midpoint", plain<Far::midpoint>},
      kTrisect,
      SchemeEntry{"centroid", plain<Far::centroid>, kBoundaryOnly, kDrop},
      SchemeEntry{"doo-sabin", plain<Far::dooSabin>, kBoundaryOnly, kDrop},
#ifdef HONEYCOMB_INTEROP
      SchemeEntry{"catmull-clark", foreign<Osd::catmullClark>, kCornersOnly, {}, false, false, false},
      SchemeEntry{"loop", foreign<Osd::loop>, kCornersOnly, {}, false, false, false},
#endif
  };
  return kSchemes;
}

std::vector<const SchemeOption*> allOptions() {
  std::vector<const SchemeOption*> all;
  for (const SchemeEntry& entry : schemes())
    for (const SchemeOption* option : entry.options)
      if (std::none_of(all.begin(), all.end(), [&](const SchemeOption* a) { return a->name == option->name; }))
        all.push_back(option);
  return all;
}

std::string ownersOf(const SchemeOption& option) {
  std::string owners;
  for (const SchemeEntry& entry : schemes())
    if (entry.has(option)) owners += (owners.empty() ? "" : ", ") + std::string(entry.name);
  return owners;
}

Far::BoundaryRule zipBoundary(std::string_view name) {
  if (name == "eq16") return Far::BoundaryRule::eq16;
  return name == "drop" ? Far::BoundaryRule::drop : Far::BoundaryRule::brick;
}

std::optional<double> parseNumber(std::string_view text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace honeycomb::Chain
