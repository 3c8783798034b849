#pragma once

#include <vector>

#include "tests/support/poly_mesh.h"
#include "tests/support/random.h"

namespace honeycomb::Test {

/// A mesh's loops under random local operations. Each either keeps the mesh an oriented manifold or leaves it as it
/// was.
class MeshEdit {
 public:
  MeshEdit(std::vector<Loop> faces, std::size_t vertexCount, std::size_t maxSides)
      : faces_(std::move(faces)), nextVertex_(vertexCount), maxSides_(maxSides) {}

  const std::vector<Loop>& faces() const { return faces_; }

  bool splitFace(Random& random);     ///< a diagonal
  bool splitEdge(Random& random);     ///< a vertex of valence 2 on an edge
  bool deleteEdge(Random& random);    ///< two faces become one
  bool collapseEdge(Random& random);  ///< two vertices become one; triangles at the edge vanish
  bool kisFace(Random& random);       ///< a triangle per side round a new vertex
  bool glueHandle(Random& random);    ///< two faces of equal side count become a tube of quads
  bool removeFace(Random& random);    ///< a hole, or a bite out of the boundary
  /// One of the first five.
  bool any(Random& random);

 private:
  bool accept(std::vector<Loop> faces);
  std::vector<Loop> without(std::size_t f) const;

  std::vector<Loop> faces_;
  std::size_t nextVertex_;
  std::size_t maxSides_;
};

}  // namespace honeycomb::Test
