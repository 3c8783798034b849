#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "far/base/result.h"
#include "far/schemes/scheme.h"

namespace CLI {
class App;
}

namespace honeycomb::Cli {

/// How to refine, as the user wrote it.
struct SchemeOptions {
  std::string scheme = "akleman";
  std::string tension = "paper";
  double edgeParameter = 0.5;
  std::string boundary = "brick";
  std::optional<double> boundaryWeight;  ///< --sn; the scheme has a default
  std::string corners = "none";
};

/// A subdivision scheme. A new one is one line of the table in scheme_options.cpp.
struct SchemeEntry {
  std::string_view name;
  Result<Far::Scheme> (*make)(const SchemeOptions&);
};
std::span<const SchemeEntry> schemes();

/// Adds --scheme and the options of all schemes.
void addSchemeOptions(CLI::App& subcommand, SchemeOptions& options);

/// The scheme the options name. Errors: invalidOption, naming the option, its range or the choices there are.
Result<Far::Scheme> makeScheme(const SchemeOptions& options);

/// Are valence-2 boundary vertices to be kept as corners?
bool keepsCorners(const SchemeOptions& options);

}  // namespace honeycomb::Cli
