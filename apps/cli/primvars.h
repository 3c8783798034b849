#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "apps/cli/mesh_input.h"
#include "apps/cli/surface_evaluator.h"
#include "far/base/result.h"
#include "far/tables/refinement.h"
#include "io/obj.h"

namespace honeycomb::Cli {

/// What a refined mesh carries beside its points: whatever its control mesh does. In the form of Io::ObjContent.
template <class Real>
struct Primvars {
  std::vector<Real> colours;                  ///< r g b a vertex; empty: none
  std::vector<Real> texcoords;                ///< u v each
  std::vector<std::int32_t> cornerTexcoords;  ///< one of them for each corner; empty: none

  /// Puts them into a mesh to be written, which refers to them then.
  void addTo(Io::ObjContent<Real>& content) const {
    content.colours = colours;
    content.texcoords = texcoords;
    content.cornerTexcoords = cornerTexcoords;
  }
};

/// Refines the colours and texture coordinates of a mesh with its tables. Where no vertex has two texture coordinates
/// they are values of the vertices, as colours are, and go through `evaluator`; else they are face-varying
/// (Far::FaceVarying). Faces without any, where others have them, are at 0 0. `centralPoints`: the tables read central
/// control vertices of the control faces too; they have the mean of their face.
template <class Real>
Result<Primvars<Real>> refinePrimvars(const MeshInput& input, const Far::Refinement& refinement, bool centralPoints,
                                      SurfaceEvaluator& evaluator);

/// u v 0 of each vertex, where no corner says otherwise or has none: else nothing, there are seams.
std::optional<std::vector<double>> texcoordsOfVertices(const Io::Mesh& mesh);

/// The texture coordinates of a mesh that has seams, refined on the CPU into those of `primvars`.
template <class Real>
Result<void> refineFaceVarying(const Io::Mesh& mesh, const Far::Refinement& refinement, Primvars<Real>& primvars);

}  // namespace honeycomb::Cli
