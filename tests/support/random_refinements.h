#pragma once

#include <cstdint>
#include <functional>

#include "tests/support/random.h"
#include "tests/support/scheme_list.h"

namespace honeycomb::Test {

/// A random mesh, two levels of a scheme with limits, and the choices a test goes on to make.
struct RandomRefinement {
  std::string name;  ///< seed, scheme, and whether there are creases
  const Far::Refinement& refinement;
  Random& choice;
};

/// Calls `check` on `rounds` random meshes under every scheme: closed, open, of several components, with creases where
/// the scheme has a rule for them. A scheme may refuse a mesh, but not all of eight or more. Throws what must not
/// happen, and stops where `check` returns false.
void forRandomRefinements(std::uint64_t rounds, const std::function<bool(const RandomRefinement&)>& check);

/// The same with one scheme a mesh, by turns: for devices, which compile kernels for every number of sides.
void forRandomRefinementsByTurns(std::uint64_t rounds, const std::function<bool(const RandomRefinement&)>& check);

/// HONEYCOMB_FUZZ_ROUNDS of the environment: how many meshes differential tests take instead of the usual number.
std::uint64_t fuzzRounds(std::uint64_t usual);

}  // namespace honeycomb::Test
