#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "far/base/result.h"
#include "io/frame_layout.h"
#include "io/frame_sequence.h"
#include "io/obj.h"

namespace honeycomb::Cli {

/// What the frames of a bake are frames of.
struct BakedMesh {
  Io::FrameInfo info;             ///< times in frames
  double framesPerSecond = 24;    ///< of the times
  std::int32_t firstFrame = 0;    ///< the first frame's number in the animation
  Io::ObjContent<float> content;  ///< the first frame as a mesh: others have other positions
};

/// How a bake's frames are stored: one of both.
struct BakeFormat {
  std::shared_ptr<const Io::FrameLayout> layout;      ///< in one file
  std::shared_ptr<const Io::FrameSequence> sequence;  ///< in a file each
};

/// Can frames be stored under this name, as far as can be told from it: a point cache by its extension, or a mesh with
/// %d or %04d in its name? Errors: invalidOption, listing what can.
Result<void> checkBakeFormat(const std::filesystem::path& path);

/// Do the files have the mesh besides its points, so that BakedMesh::content is needed?
bool storesMesh(const std::filesystem::path& path);

/// The format of a path's name. `mesh` outlives a sequence. Errors: checkBakeFormat's; those of the format.
Result<BakeFormat> bakeFormat(const std::filesystem::path& path, const BakedMesh& mesh);

/// The times of the frames that are baked, in frames, from an animation that counts its own way.
BakedMesh bakedTimes(const Io::FrameInfo& animation, std::int32_t begin, std::int32_t frames, std::int32_t points);

}  // namespace honeycomb::Cli
