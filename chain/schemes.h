#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "chain/scheme_options.h"
#include "far/base/result.h"
#include "far/schemes/scheme.h"
#include "far/topology/splits/zip.h"

namespace honeycomb::Chain {

/// Where a scheme is to take a mesh.
struct SchemeRequest {
  const SchemeOptions& options;
  const Far::Topology& mesh;  ///< the control mesh, or what the schemes before make of it
  std::int32_t levels = 0;
  std::string_view boundary;  ///< one of the entry's boundaries; empty where it has none
};

/// A subdivision scheme: one file in chain/schemes, or one line of the table in schemes.cpp where it has no options.
struct SchemeEntry {
  std::string_view name;
  /// The steps of that many levels; more steps than levels begin with conversions.
  /// Errors: invalidOption for a value that is out of range or none of its choices; invalidMesh.
  Result<std::vector<Far::Scheme>> (*make)(const SchemeRequest&) = nullptr;
  std::span<const SchemeOption* const> options = {};
  std::span<const std::string_view> boundaries = {};  ///< values of --boundary, the default first
  bool looksAtMesh = false;                           ///< make() reads the request's mesh
  bool centralPoints = false;                         ///< its first step reads central control vertices
  bool limits = true;                                 ///< limit positions and normals are known
  bool patches = false;                               ///< its limit surface has a PatchTable

  /// Is it an option of this scheme?
  bool has(const SchemeOption& option) const {
    return std::any_of(options.begin(), options.end(),
                       [&](const SchemeOption* own) { return own->name == option.name; });
  }
};
std::span<const SchemeEntry> schemes();

/// The options of all schemes, each once, in the order of their table.
std::vector<const SchemeOption*> allOptions();

/// "akleman, zhang-wang": the schemes that have an option.
std::string ownersOf(const SchemeOption& option);

/// The entries behind the table.
extern const SchemeEntry kAkleman, kZhangWang, kHalfBox, kTrisect;

/// --ccv and --ccv-offset, of schemes with central control vertices, and --tuned, of half-box.
extern const SchemeOption kCentralFileOption, kCentralOffsetOption, kTunedOption;

/// The rule of the zip split of that name: brick, eq16 or drop.
Far::BoundaryRule zipBoundary(std::string_view name);

/// The whole text as a number.
std::optional<double> parseNumber(std::string_view text);

}  // namespace honeycomb::Chain
