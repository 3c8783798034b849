#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "far/base/result.h"
#include "io/frame_layout.h"
#include "io/obj.h"

namespace honeycomb::Io {

/// Files past this are refused: counts of glTF end at 2^32 bytes, and many readers' (browsers' among them) at 2^31.
constexpr std::int64_t kMostGlbBytes = (std::int64_t{1} << 31) - 1;

/// A glTF 2.0 file (.glb) of one mesh that moves: the first frame as positions, each other one as a morph target (its
/// differences from the first: the sums are within a rounding of the frames), and an animation of the targets' weights
/// that goes linearly from one to the next. glTF has triangles only, so faces are cut (triangulate(), by the first
/// frame); vertices with several texture coordinates are several; v counts downwards, as glTF has it. Readers take flat
/// normals where `content` has none; of a mesh that moves normals aren't written.
///     | glb header | JSON, with room for what is known at the end | indices, uv, colours, normals, times, weights |
///     | positions of frame 0 | differences of frame 1 | ...
/// `content`: the first frame, copied. `info`: start and rate in seconds. Errors: checkContent's; invalidOption for
/// counts that don't fit and times that don't ascend; tooLarge past kMostGlbBytes, naming what takes more.
Result<std::shared_ptr<const FrameLayout>> glbLayout(std::string_view name, const ObjContent<float>& content,
                                                     const FrameInfo& info);

/// Writes one mesh, in single precision. Errors: those of glbLayout; invalidPositions for what doesn't fit in single
/// precision; unwritable.
template <class Real>
Result<void> writeGlb(const std::filesystem::path& path, const ObjContent<Real>& content);

}  // namespace honeycomb::Io
