#include "far/topology/spatial_order.h"

#include <array>
#include <numeric>

#include "far/base/index.h"
#include "far/base/parallel.h"

namespace honeycomb::Far {

namespace {

/// Faces of a patch, outermost first: what a quad needs through four levels of zip (about 10 kB) times these numbers
/// fits a last-level cache and a core's own.
constexpr std::array<std::size_t, 2> kPatchFaces{2048, 64};

/// Per corner: the face across its edge, -1 on a boundary.
std::vector<std::int32_t> facesAcross(const Inspection& inspection) {
  const std::vector<std::int32_t>& twin = inspection.edges.twin;
  std::vector<std::int32_t> across(twin.size());
  Parallel::forEach(0, static_cast<std::int64_t>(twin.size()), [&](std::int64_t c) {
    across[at(c)] = twin[at(c)] < 0 ? -1 : inspection.cornerFace[at(twin[at(c)])];
  });
  return across;
}

/// Grows the patches of a round, and cuts each at once, while the cache has it, into those of the next round.
class PatchGrower {
 public:
  PatchGrower(const Polygons& polygons, std::vector<std::int32_t> across)
      : polygons_(polygons), across_(std::move(across)), patch_(at(polygons.faceCount()), 0) {}

  std::vector<std::int32_t> run() {
    std::vector<std::int32_t> all(patch_.size());
    std::iota(all.begin(), all.end(), 0);
    order_.reserve(all.size());
    cut(all, 0, 0);
    return std::move(order_);
  }

 private:
  struct Round {
    std::vector<std::int32_t> faces;  ///< of the patch that grows
    std::vector<std::int32_t> near;   ///< next to it, nearest first; also faces that have been taken since
    std::vector<std::int32_t> rim;    ///< next to patches before, where the next ones begin
  };

  /// `faces` are those of patch `outer`.
  void cut(const std::vector<std::int32_t>& faces, std::int32_t outer, std::size_t round) {
    if (round == rounds_.size()) {
      order_.insert(order_.end(), faces.begin(), faces.end());
      return;
    }
    std::vector<std::int32_t>& rim = rounds_[round].rim;
    for (const std::int32_t first : faces) {
      rim.assign(1, first);
      for (std::size_t i = 0; i < rim.size(); ++i) {
        if (patch_[at(rim[i])] == outer) grow(rim[i], outer, round);
      }
    }
  }

  /// A patch of the faces of patch `outer` that are nearest to the first.
  void grow(std::int32_t first, std::int32_t outer, std::size_t round) {
    auto& [faces, near, rim] = rounds_[round];
    const std::int32_t patch = ++patchCount_;
    faces.clear();
    near.assign(1, first);
    std::size_t next = 0;
    for (; next < near.size() && faces.size() < kPatchFaces[round]; ++next) {
      const std::int32_t f = near[next];
      if (patch_[at(f)] != outer) continue;
      patch_[at(f)] = patch;
      faces.push_back(f);
      for (std::int64_t c = polygons_.faceOffsets[at(f)]; c < polygons_.faceOffsets[at(f) + 1]; ++c) {
        const std::int32_t g = across_[at(c)];
        if (g >= 0 && patch_[at(g)] == outer) near.push_back(g);
      }
    }
    for (; next < near.size(); ++next) {
      if (patch_[at(near[next])] == outer) rim.push_back(near[next]);
    }
    cut(faces, patch, round + 1);
  }

  const Polygons& polygons_;
  const std::vector<std::int32_t> across_;
  std::vector<std::int32_t> patch_;  ///< per face: the smallest patch it is in so far
  std::int32_t patchCount_ = 0;
  std::array<Round, kPatchFaces.size()> rounds_;
  std::vector<std::int32_t> order_;
};

}  // namespace

std::vector<std::int32_t> spatialFaceOrder(const Polygons& polygons, const Inspection& inspection) {
  return PatchGrower(polygons, facesAcross(inspection)).run();
}

std::vector<std::int32_t> spatialVertexOrder(const Topology& topology) {
  std::vector<std::uint8_t> met(at(topology.vertexCount()), 0);
  std::vector<std::int32_t> order;
  order.reserve(met.size());
  for (const std::int32_t v : topology.vert()) {
    if (met[at(v)] == 0) order.push_back(v);
    met[at(v)] = 1;
  }
  return order;
}

}  // namespace honeycomb::Far
