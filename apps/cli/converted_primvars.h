#pragma once

#include <vector>

#include "apps/cli/mesh_input.h"
#include "apps/cli/primvars.h"
#include "far/base/result.h"
#include "far/conversions/conversion.h"

namespace honeycomb::Cli {

/// The primvars of a converted mesh.
struct ConvertedPrimvars {
  Primvars<double> values;
  bool texcoordsLeftOut = false;  ///< they have seams, which this conversion can't follow
};

/// Carries the colours and texture coordinates of a mesh along with its conversion, by the rows of its points;
/// `control` is its topology. Texture coordinates with seams follow where the conversion is a step of a scheme
/// (Far::FaceVarying) or every face lies in the face it was made from, and are left out else. Where the inverse dual
/// has no solution for colours or texture coordinates, they are those of the geometric dual.
Result<ConvertedPrimvars> convertPrimvars(const MeshInput& input, const Far::Topology& control,
                                          const Far::Conversion& conversion);

}  // namespace honeycomb::Cli
