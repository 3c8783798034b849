#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "far/conversions/conversion.h"

namespace honeycomb::Far {

/// The faces and corners of a level-0 topology by the caller's numbers: corner c is the place of a half-edge in the
/// concatenated loops as the caller gave them. What conversions number their results by.
class CallerFaces {
 public:
  explicit CallerFaces(const Topology& topology);

  std::int32_t count() const { return topology_->faceCount(); }
  /// The topology's number of the caller's face f.
  std::int32_t sorted(std::int32_t f) const { return sorted_[index(f)]; }
  /// The first half-edge of the caller's face f; its others follow.
  std::int32_t halfEdge(std::int32_t f) const { return topology_->faceOffsets()[index(sorted(f))]; }
  std::int32_t sides(std::int32_t f) const { return firstCorner(f + 1) - firstCorner(f); }
  std::span<const std::int32_t> loop(std::int32_t f) const {
    return topology_->vert().subspan(index(halfEdge(f)), index(sides(f)));
  }
  /// Corners of the faces before f; f may be count().
  std::int32_t firstCorner(std::int32_t f) const { return firstCorner_[index(f)]; }
  /// The caller's corner that half-edge h leaves from.
  std::int32_t corner(std::int32_t h) const {
    const std::int32_t f = topology_->face(h);
    return firstCorner(topology_->inputFace(f)) + h - topology_->faceOffsets()[index(f)];
  }

 private:
  static constexpr std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }
  const Topology* topology_;
  std::vector<std::int32_t> sorted_;
  std::vector<std::int32_t> firstCorner_;
};

/// Gives the polygons one face of each side count, in order; the corners are to be filled in.
void layOutFaces(Polygons& polygons, std::span<const std::int32_t> sides);
/// The corners of face f of polygons laid out so.
std::span<std::int32_t> faceLoop(Polygons& polygons, std::int64_t f);

/// Gives the rows their lengths, in order; the entries are to be filled in.
void layOutRows(WeightedRows& rows, std::span<const std::int32_t> lengths);
/// Row r becomes the mean of the given vertices, as many as it is long: a copy where it is one.
void setMean(WeightedRows& rows, std::int64_t r, std::span<const std::int32_t> vertices);

/// Errors: tooLarge when a result can't be numbered in 32 bits. `what`: "the dual".
Result<void> checkSize(std::string_view what, std::int64_t vertices, std::int64_t corners);

/// Faces at each vertex, in parallel.
std::vector<std::int32_t> countFacesAt(const Topology& topology);
/// Errors: invalidMesh naming the first vertex inside the mesh with only two faces, which would become a face of two
/// sides of `what`.
Result<void> checkInsideVertices(std::string_view what, const Topology& topology,
                                 std::span<const std::int32_t> facesAt);

/// Boundary vertices of the source that are tagged to stay corners, for results that keep its vertices.
std::vector<std::int32_t> taggedCorners(const Topology& topology);

/// A result whose vertices are those of the mesh and then the centres (means of the corners) of its faces in the
/// caller's order; without faces yet. Errors: tooLarge, also for more than `corners` corners.
Result<Conversion> verticesAndCentres(std::string_view what, const Topology& topology, const CallerFaces& faces,
                                      std::int64_t corners);

}  // namespace honeycomb::Far
