#pragma once

#include <memory>
#include <string>

#include "apps/cli/frame_range.h"
#include "apps/cli/mesh_input.h"
#include "apps/cli/read_options.h"
#include "far/base/result.h"
#include "io/frame_source.h"

namespace CLI {
class App;
}

namespace honeycomb::Cli {

/// Which animation moves a mesh, and which of its frames are meant.
struct AnimationOptions {
  std::string cache;   ///< a file of frames; empty: those that the mesh's own file has
  std::string frames;  ///< a:b; empty: all
};

/// Adds --cache and --frames, and --fps, which is asked of whatever is read.
void addAnimationOptions(CLI::App& subcommand, AnimationOptions& options, ReadOptions& read);

/// The frames of a mesh, in the numbering of its file (MeshInput::fileVertices points each).
struct Animation {
  std::shared_ptr<const Io::FrameSource> frames;
  FrameRange range;
  std::string file;  ///< for messages
};

/// At the rate that was asked for: a clip is sampled at its moments, between the frames of other animations points move
/// on lines; those that don't say how fast they are have 24 frames a second. Errors: invalidOption where there is
/// nothing that moves, for such a rate, and for a range that isn't there; those of the reader;
/// invalidFile where the frames are of another mesh.
Result<Animation> openAnimation(const AnimationOptions& options, const MeshInput& input);

/// The points of a frame without the vertices that were left out, in the order of `input`: `frame` itself, or gathered
/// into `storage`.
std::span<const float> takeVertices(const MeshInput& input, std::span<const float> frame, std::vector<float>& storage);

}  // namespace honeycomb::Cli
