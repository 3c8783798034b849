#include "tests/support/random_mesh.h"

#include <algorithm>
#include <map>
#include <set>

#include "tests/support/manifold_check.h"
#include "tests/support/mesh_edit.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

constexpr std::size_t kMaxSides = 64;
constexpr std::size_t kMaxFaces = 150;

/// A grid or torus of random size. The columns are drawn first: arguments would be evaluated in an order of the
/// compiler's.
PolyMesh randomRows(PolyMesh (*make)(std::size_t, std::size_t), Random& random, std::size_t least) {
  const std::size_t columns = random.between(least, 6);
  const std::size_t rows = random.between(least, 6);
  return make(rows, columns);
}

PolyMesh randomBase(Random& random, Border border) {
  switch (random.below(border == Border::open ? 8 : 6)) {
    case 0:
      return tetrahedron();
    case 1:
      return cube();
    case 2:
      return dodecahedron();
    case 3:
      return randomRows(torus, random, 3);
    case 4:
      return prism(random.between(3, 12));
    case 5:
      return prism(random.between(13, kMaxSides));
    case 6:
      return wheel(random.between(3, 9));
    default:
      return randomRows(grid, random, 1);
  }
}

std::vector<Loop> randomComponent(Random& random, Border border) {
  const PolyMesh base = randomBase(random, border);
  MeshEdit edit(base.faces, base.points.size(), kMaxSides);
  for (std::size_t ops = random.below(40); ops > 0 && edit.faces().size() < kMaxFaces; --ops) edit.any(random);
  if (random.chance(0.4)) {
    std::size_t handles = random.between(1, 3);
    for (int tries = 0; tries < 20 && handles > 0; ++tries) handles -= edit.glueHandle(random) ? 1 : 0;
  }
  if (border == Border::open) {
    for (std::size_t bites = random.below(1 + edit.faces().size() / 4); bites > 0; --bites) edit.removeFace(random);
    // Any face of a closed mesh can be taken out; two edges of one face at a vertex of valence 2 make it a bite.
    for (int tries = 0; tries < 200 && boundaryEdgeCount(edit.faces()) == 0; ++tries) edit.removeFace(random);
  }
  return edit.faces();
}

/// Gives the vertices that are used random new numbers from `first` on, and turns every loop at random.
std::size_t renumber(std::vector<Loop>& faces, std::size_t first, Random& random) {
  std::set<std::size_t> used;
  for (const Loop& loop : faces) used.insert(loop.begin(), loop.end());
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < used.size(); ++i) numbers.push_back(first + i);
  random.shuffle(numbers);
  std::map<std::size_t, std::size_t> renamed;
  for (const std::size_t v : used) renamed.insert({v, numbers[renamed.size()]});
  for (Loop& loop : faces) {
    for (std::size_t& v : loop) v = renamed.at(v);
    std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(random.below(loop.size())), loop.end());
  }
  return first + used.size();
}

std::vector<std::size_t> boundaryVertices(const std::vector<Loop>& faces) {
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for (const Loop& loop : faces) {
    for (std::size_t i = 0; i < loop.size(); ++i) edges.insert({loop[i], loop[(i + 1) % loop.size()]});
  }
  std::vector<std::size_t> vertices;
  for (const auto& [from, to] : edges) {
    if (!edges.contains({to, from})) vertices.push_back(from);
  }
  return vertices;
}

}  // namespace

RandomMesh randomMesh(std::uint64_t seed, Border border) {
  Random random(seed);
  RandomMesh result;
  std::size_t vertexCount = 0;
  for (std::size_t parts = random.chance(0.3) ? random.between(2, 3) : 1; parts > 0; --parts) {
    std::vector<Loop> component = randomComponent(random, border);
    vertexCount = renumber(component, vertexCount, random);
    for (Loop& loop : component) result.mesh.faces.push_back(std::move(loop));
  }
  random.shuffle(result.mesh.faces);
  for (std::size_t v = 0; v < vertexCount; ++v) {
    result.mesh.points.push_back({random.symmetric(), random.symmetric(), random.symmetric()});
  }
  for (const std::size_t v : boundaryVertices(result.mesh.faces)) {
    if (random.chance(0.15)) result.cornerTags.push_back(v);
  }
  return result;
}

}  // namespace honeycomb::Test
