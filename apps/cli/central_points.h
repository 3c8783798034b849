#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "apps/cli/chain.h"
#include "apps/cli/mesh_input.h"
#include "far/base/result.h"
#include "io/pc2.h"

namespace honeycomb::Cli {

/// Where the central control vertices of a mesh's faces are, one a face in file order.
struct CentralPoints {
  bool given = false;                  ///< false: at the barycentres, which the tables see to
  std::vector<double> offsets{0.0};    ///< distances from the barycentres along the normals, where they aren't in a
                                       ///< file: one for all faces, or one a face
  std::string file;                    ///< --ccv; empty: none
  std::vector<double> positions;       ///< x y z a face, of an OBJ
  std::optional<Io::Pc2Reader> cache;  ///< frames of them, of a PC2
};

/// Central control vertices of one pose, from --ccv F.obj or --ccv-offset.
/// Errors: those of the file; invalidFile, naming both numbers, when there are not as many as faces; invalidOption.
Result<CentralPoints> readCentralPoints(const SchemeOptions& options, const MeshInput& input);

/// The same for each frame of an animation of `frameCount` frames, from --ccv F.pc2 or --ccv-offset.
Result<CentralPoints> readCentralCache(const SchemeOptions& options, const MeshInput& input, std::int32_t frameCount);

/// Appends the central control vertices of a pose to its vertices, x y z each: those at the offsets (one, or one a
/// face) from the barycentres of the faces of `polygons`. A face without a normal keeps its barycentre. Parallel.
template <class Real>
void appendOffsetPoints(const Far::Polygons& polygons, std::span<const double> offsets, std::vector<Real>& points);

}  // namespace honeycomb::Cli
