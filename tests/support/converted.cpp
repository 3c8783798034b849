#include "tests/support/converted.h"

#include <set>
#include <stdexcept>

#include "tests/support/refined.h"

namespace honeycomb::Test {

PolyMesh converted(const Result<Far::Conversion>& conversion, const std::vector<Vec3>& points) {
  if (!conversion) throw std::runtime_error(conversion.error().message);
  const auto positions = Far::apply(*conversion, pack<double>(points), 3);
  if (!positions) throw std::runtime_error(positions.error().message);
  PolyMesh mesh{unpack<double>(*positions), {}};
  const Far::Polygons& polygons = conversion->polygons;
  for (std::int64_t f = 0; f < polygons.faceCount(); ++f) {
    mesh.faces.emplace_back(polygons.indices.begin() + at(polygons.faceOffsets, f),
                            polygons.indices.begin() + at(polygons.faceOffsets, f + 1));
  }
  return mesh;
}

bool isThreeValent(const PolyMesh& mesh) {
  std::vector<std::set<std::size_t>> neighbours(mesh.points.size());
  std::vector<std::size_t> faces(mesh.points.size(), 0);
  for (const Loop& loop : mesh.faces) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::size_t a = loop[i], b = loop[(i + 1) % loop.size()];
      neighbours[a].insert(b);
      neighbours[b].insert(a);
      ++faces[a];
    }
  }
  for (std::size_t v = 0; v < faces.size(); ++v) {
    const bool boundary = faces[v] < neighbours[v].size();
    if (neighbours[v].size() != 3 && !(boundary && neighbours[v].size() == 2)) return false;
  }
  return true;
}

}  // namespace honeycomb::Test
