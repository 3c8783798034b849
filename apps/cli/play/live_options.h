#pragma once

#include <string>
#include <vector>

#include "apps/cli/chain.h"
#include "apps/cli/play/surface.h"

namespace honeycomb::Cli::Play {

/// The options that the schemes of a request have, in the order of their tables; empty where the scheme is unknown.
std::vector<const SchemeOption*> optionsOf(const SurfaceRequest& request);

/// The levels a request asks for.
std::int32_t levelsOf(const SurfaceRequest& request);

/// Another scheme, or a chain with levels of its own: options that it doesn't have are given up.
void setScheme(SurfaceRequest& request, const std::string& scheme);
void setLevels(SurfaceRequest& request, std::int32_t levels);
/// The scheme before or after `from` in the table.
void stepScheme(SurfaceRequest& request, const std::string& from, int direction);

/// What an option can be, where that is a list: boundary rules, flags; empty: anything.
std::vector<std::string> choicesOf(const SurfaceRequest& request, const SchemeOption& option);
/// The next of its choices, or a number a twentieth more or less.
void stepOption(SurfaceRequest& request, const SchemeOption& option, int direction);

}  // namespace honeycomb::Cli::Play
