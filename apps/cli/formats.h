#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "far/base/result.h"
#include "io/frame_source.h"
#include "io/mesh.h"
#include "io/mesh_formats.h"
#include "io/mesh_output.h"
#include "io/obj.h"
#include "io/point_cache.h"
#include "io/scene/scene_format.h"

namespace honeycomb::Cli {

using Io::lowerExtension;
using Io::meshInputNames;
using Io::MeshOutput;
using Io::meshOutput;
using Io::meshReader;
using Io::pointCache;
using Io::ReadMesh;

/// What the help of a command that plays says of its input: those, or a mesh a frame.
std::string animatedInputHelp();

/// Can the output be what the user wants, as far as can be told before the work is done: in a folder that is there and
/// can be written, no folder itself, and none of the inputs. Errors: unwritable, invalidOption.
Result<void> checkOutput(const std::filesystem::path& output, std::span<const std::filesystem::path> inputs);

}  // namespace honeycomb::Cli
