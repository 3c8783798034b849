#include "tests/support/random_refinements.h"

#include <cstdlib>
#include <optional>
#include <stdexcept>

#include "far/schemes/akleman.h"
#include "far/schemes/half_box.h"
#include "tests/support/creased.h"
#include "tests/support/refined.h"

namespace honeycomb::Test {
namespace {

constexpr std::int32_t kLevels = 2;

/// All schemes, and those whose weights may be negative.
std::vector<ListedScheme> schemesToTry() {
  std::vector<ListedScheme> schemes = listedSchemes();
  const auto add = [&schemes](const char* name, const Far::HalfBoxOptions& options) {
    schemes.push_back({name, [options](const Far::Topology& control, std::int32_t levels) {
                         return Far::halfBox(control, levels, options);
                       }});
  };
  add("half-box clamped", {.conversion = Far::HalfBoxConversion::akleman, .boundary = Far::HalfBoxBoundary::clamped});
  add("half-box of the dual", {.conversion = Far::HalfBoxConversion::dual});
  return schemes;
}

/// Nothing where the scheme has no rule for the mesh.
std::optional<Far::Refinement> tryRefining(const ListedScheme& scheme, const Far::Topology& control) {
  const auto chain = scheme.chain(control, kLevels);
  auto refinement = chain ? Far::refine(control, *chain, {.limits = true}) : tl::unexpected(chain.error());
  if (refinement) return std::move(*refinement);
  const Error& error = refinement.error();
  const bool refused = error.code == ErrorCode::invalidMesh || error.code == ErrorCode::invalidOption;
  if (!refused || error.message.empty()) throw std::runtime_error(scheme.name + ": " + error.message);
  return std::nullopt;
}

using Check = std::function<bool(const RandomRefinement&)>;

/// How many of the mesh's two topologies, smooth and creased, the scheme took; -1: `check` ended it.
int tryAll(std::uint64_t seed, const ListedScheme& scheme, const Check& check) {
  const RandomMesh mesh = randomMesh(seed);
  Random choice(seed);
  int taken = 0;
  for (const bool creases : {false, true}) {
    const Far::Topology control =
        creases ? randomlyCreased(mesh, choice, {0.5, 1.25, 2, Far::kSharp}) : toTopology(mesh.mesh, mesh.cornerTags);
    const auto refinement = tryRefining(scheme, control);
    if (!refinement) continue;
    const std::string name = "seed " + std::to_string(seed) + ", " + scheme.name + (creases ? ", creased" : "");
    if (!check({name, *refinement, choice})) return -1;
    ++taken;
  }
  return taken;
}

}  // namespace

std::uint64_t fuzzRounds(std::uint64_t usual) {
  const char* rounds = std::getenv("HONEYCOMB_FUZZ_ROUNDS");
  return rounds == nullptr ? usual : std::stoull(rounds);
}

void forRandomRefinements(std::uint64_t rounds, const Check& check) {
  for (const ListedScheme& scheme : schemesToTry()) {
    int taken = 0;
    for (std::uint64_t seed = 0; seed < rounds; ++seed) {
      const int more = tryAll(seed, scheme, check);
      if (more < 0) return;
      taken += more;
    }
    if (taken == 0 && rounds >= 8) throw std::runtime_error(scheme.name + " takes none of the meshes");
  }
}

void forRandomRefinementsByTurns(std::uint64_t rounds, const Check& check) {
  const std::vector<ListedScheme> schemes = schemesToTry();
  for (std::uint64_t seed = 0; seed < rounds; ++seed) {
    if (tryAll(seed, schemes[seed % schemes.size()], check) < 0) return;
  }
}

}  // namespace honeycomb::Test
