#include "apps/cli/read_options.h"

#include <CLI/CLI.hpp>

namespace honeycomb::Cli {

void addReadOptions(CLI::App& subcommand, ReadOptions& options) {
  subcommand.add_flag("--drop-isolated", options.dropIsolated, "Leave out vertices that are in no face");
  subcommand.add_flag("--split-nonmanifold", options.splitNonManifold,
                      "Duplicate vertices until the mesh is an oriented manifold, cutting it open along wrong edges");
  subcommand.add_flag("--quads", options.quads, "Join pairs of triangles to quads where a triangulation cut them");
  subcommand.add_option("--clip", options.clip, "Animation of a scene to play, by name (default: its first)");
  subcommand.add_option("--node", options.node,
                        "Node of a scene whose meshes are meant, with those below it (default: all)");
  subcommand.add_option(
      "--weld", options.weld,
      "Join vertices of a scene that seams have split, within this part of the bounding box's diagonal "
      "(default: 1e-6); 0: at exactly the same place");
}

}  // namespace honeycomb::Cli
