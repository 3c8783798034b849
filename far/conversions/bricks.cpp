#include "far/conversions/bricks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/conversions/conversion_parts.h"
#include "far/conversions/quad_tubes.h"

namespace honeycomb::Far {
namespace {

/// The courses of one tube.
class Masonry {
 public:
  Masonry(const QuadTube& tube, std::int32_t rows, std::span<const std::int32_t> kept, std::int32_t firstVertex)
      : tube_(tube), rows_(rows), courses_(tube.rings * rows), kept_(kept), firstVertex_(firstVertex) {}

  std::int32_t courses() const { return courses_; }
  /// Slots of a line, and vertices of a line that isn't a rim.
  std::int32_t slots() const { return 2 * tube_.columns; }
  bool isRim(std::int32_t line) const { return line == 0 || line == courses_; }

  /// The result's vertex in a slot; of a rim only slots where a joint ends.
  std::int32_t vertex(std::int32_t line, std::int32_t slot) const {
    if (line == 0) return kept_[at(tube_.vertex(0, slot / 2))];
    if (line == courses_) return kept_[at(tube_.vertex(tube_.rings, (slot + lean()) / 2))];
    return firstVertex_ + (line - 1) * slots() + slot % slots();
  }

  /// A point on one of the tube's quads.
  struct Place {
    std::int32_t ring = 0, column = 0;
    double up = 0, right = 0;  ///< from the quad's lower left corner, in [0, 1)
  };
  Place place(std::int32_t line, std::int32_t slot) const { return placeOf(2 * line, 2 * slot); }
  /// The centre of brick i of a course.
  Place centre(std::int32_t course, std::int32_t i) const {
    return placeOf(2 * course - 1, 2 * (firstSlot(course) + 2 * i + 1));
  }

  /// The slot of the first joint of a course, counted from 1.
  static std::int32_t firstSlot(std::int32_t course) { return (course - 1) % 2; }

  /// The corners of brick i of a course, counter-clockwise from the lower left.
  std::vector<std::int32_t> brick(std::int32_t course, std::int32_t i) const {
    const std::int32_t left = firstSlot(course) + 2 * i;
    std::vector<std::int32_t> loop{vertex(course - 1, left)};
    if (!isRim(course - 1)) loop.push_back(vertex(course - 1, left + 1));
    loop.push_back(vertex(course - 1, left + 2));
    loop.push_back(vertex(course, left + 2));
    if (!isRim(course)) loop.push_back(vertex(course, left + 1));
    loop.push_back(vertex(course, left));
    return loop;
  }

 private:
  /// Half columns that the courses lean from rim to rim.
  std::int32_t lean() const { return courses_ % 2 == 0 ? 1 : 0; }

  /// From half lines and half slots.
  Place placeOf(std::int32_t halfLine, std::int32_t halfSlot) const {
    const std::int64_t ringUnit = 2 * std::int64_t{rows_}, columnUnit = 8 * std::int64_t{courses_};
    const std::int64_t x = 2 * std::int64_t{halfSlot} * courses_ + 2 * std::int64_t{lean()} * halfLine;
    Place place;
    place.ring = static_cast<std::int32_t>(halfLine / ringUnit);
    place.up = static_cast<double>(halfLine % ringUnit) / static_cast<double>(ringUnit);
    place.column = static_cast<std::int32_t>(x / columnUnit % tube_.columns);
    place.right = static_cast<double>(x % columnUnit) / static_cast<double>(columnUnit);
    return place;
  }

  const QuadTube& tube_;
  std::int32_t rows_, courses_;
  std::span<const std::int32_t> kept_;
  std::int32_t firstVertex_;
};

/// Adds a row for a place on the tube's quads; corners that have no part in it are left out.
void addRow(WeightedRows& rows, const QuadTube& tube, const Masonry::Place& p) {
  for (const std::int32_t line : {0, 1}) {
    for (const std::int32_t column : {0, 1}) {
      const double weight = (line == 1 ? p.up : 1 - p.up) * (column == 1 ? p.right : 1 - p.right);
      if (weight == 0) continue;
      rows.indices.push_back(tube.vertex(p.ring + line, p.column + column));
      rows.weights.push_back(weight);
    }
  }
  rows.offsets.push_back(static_cast<std::int64_t>(rows.indices.size()));
}

/// The number of each vertex in the result, -1 for those inside a tube; adds their rows.
std::vector<std::int32_t> keepVertices(const Topology& topology, const std::vector<QuadTube>& tubes,
                                       Conversion& result) {
  std::vector<std::int32_t> kept(at(topology.vertexCount()), 0);
  for (const QuadTube& tube : tubes)
    std::for_each(tube.vertices.begin() + tube.columns, tube.vertices.end() - tube.columns,
                  [&](std::int32_t v) { kept[at(v)] = -1; });
  for (std::int32_t v = 0; v < topology.vertexCount(); ++v) {
    if (kept[at(v)] < 0) continue;
    kept[at(v)] = result.polygons.vertexCount++;
    result.rows.indices.push_back(v);
    result.rows.weights.push_back(1);
    result.rows.offsets.push_back(static_cast<std::int64_t>(result.rows.indices.size()));
  }
  for (const std::int32_t v : taggedCorners(topology)) result.polygons.corners.push_back(kept[at(v)]);
  return kept;
}

void keepFaces(const CallerFaces& faces, const std::vector<QuadTube>& tubes, std::span<const std::int32_t> kept,
               Conversion& result) {
  std::vector<std::uint8_t> laid(at(faces.count()), 0);
  for (const QuadTube& tube : tubes)
    for (const std::int32_t f : tube.faces) laid[at(f)] = 1;
  for (std::int32_t f = 0; f < faces.count(); ++f) {
    if (laid[at(faces.sorted(f))] != 0) continue;
    std::vector<std::int32_t> loop;
    for (const std::int32_t v : faces.loop(f)) loop.push_back(kept[at(v)]);
    result.polygons.addFace(loop);
    result.faceSources.push_back({FaceParent::face, f});
  }
}

void lay(const Topology& topology, const QuadTube& tube, const Masonry& masonry, Conversion& result) {
  for (std::int32_t line = 1; line < masonry.courses(); ++line)
    for (std::int32_t slot = 0; slot < masonry.slots(); ++slot) addRow(result.rows, tube, masonry.place(line, slot));
  result.polygons.vertexCount += (masonry.courses() - 1) * masonry.slots();
  for (std::int32_t course = 1; course <= masonry.courses(); ++course) {
    for (std::int32_t i = 0; i < tube.columns; ++i) {
      result.polygons.addFace(masonry.brick(course, i));
      const Masonry::Place centre = masonry.centre(course, i);
      result.faceSources.push_back({FaceParent::face, topology.inputFace(tube.face(centre.ring, centre.column))});
    }
  }
}

/// Vertices and corners, as far as the tubes bring them.
Result<void> checkTubes(const Topology& topology, const std::vector<QuadTube>& tubes, std::int32_t rows) {
  if (tubes.empty())
    return fail(ErrorCode::invalidMesh,
                "there is nothing to lay bricks on: give a mesh with a closed ring of quads, or several upon one "
                "another, between two caps that are one polygon, faces that aren't quads, or open, such as a prism");
  std::int64_t bricks = 0;
  for (const QuadTube& tube : tubes) bricks += std::int64_t{tube.columns} * tube.rings * rows;
  return checkSize("the bricks", topology.vertexCount() + 2 * bricks, topology.halfEdgeCount() + 6 * bricks);
}

}  // namespace

Result<Conversion> bricks(const Topology& topology, std::int32_t rows) {
  if (rows < 1 || rows > kMaxBrickRows)
    return fail(ErrorCode::invalidOption, fmt::format("rows {}: must lie between 1 and {}", rows, kMaxBrickRows));
  const CallerFaces faces(topology);
  const std::vector<QuadTube> tubes = findQuadTubes(topology, faces);
  if (const auto fits = checkTubes(topology, tubes, rows); !fits) return tl::unexpected(fits.error());
  Conversion result;
  result.sourceCount = topology.vertexCount();
  const std::vector<std::int32_t> kept = keepVertices(topology, tubes, result);
  keepFaces(faces, tubes, kept, result);
  for (const QuadTube& tube : tubes)
    lay(topology, tube, Masonry(tube, rows, kept, result.polygons.vertexCount), result);
  return result;
}

}  // namespace honeycomb::Far
