#pragma once

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace honeycomb::Cli {

/// How a mesh is read from its file, whatever its format. What a format hasn't (clips, nodes) is an error to ask for.
struct ReadOptions {
  bool dropIsolated = false;              ///< leave out vertices that are in no face
  bool splitNonManifold = false;          ///< duplicate vertices until the mesh is a manifold
  std::string clip;                       ///< animation to play; empty: the file's first
  std::string node;                       ///< node whose meshes are meant, and those below it; empty: all
  std::optional<double> framesPerSecond;  ///< of the animation; none: as it was made
  std::optional<double> weld;  ///< distance in diagonals of the bounding box within which split vertices are joined
  bool quads = false;          ///< pair triangles to quads
};

/// Adds the options above to a subcommand, but --fps, which is for those that play (addAnimationOptions).
void addReadOptions(CLI::App& subcommand, ReadOptions& options);

}  // namespace honeycomb::Cli
