#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/tables/patch_table.h"

namespace honeycomb::Far {
namespace {

/// Numbers the vertices [corners of patches | edges | insides] and writes samples and triangles. A patch's grid of
/// K x K triangles has rows r = 0..K of columns c = 0..r, at u = (K-r, r-c, c)/K:
///               0,0              J_0
///            1,0   1,1
///         2,0   2,1   2,2        J_1 .. J_2
class Tessellator {
 public:
  Tessellator(const PatchTable& patches, std::int32_t pieces)
      : patches_(patches), topology_(patches.topology()), pieces_(pieces) {}

  Result<Tessellation> run() {
    placeCorners();
    placeEdges();
    if (Result<void> fits = checkSize(); !fits) return tl::unexpected(fits.error());
    result_.samples.resize(at(vertexCount()));
    result_.polygons.vertexCount = static_cast<std::int32_t>(vertexCount());
    sampleCorners();
    sampleEdges();
    sampleInsides();
    writeTriangles();
    return std::move(result_);
  }

 private:
  std::int32_t patchAt(std::int32_t halfEdge) const { return patches_.patchOf(topology_.vert(halfEdge)); }
  /// A run of a face is a sequence of corners whose patches follow each other over shared edges; this is its first.
  bool startsRun(std::int32_t halfEdge) const {
    return patchAt(halfEdge) >= 0 && patchAt(topology_.prev(halfEdge)) < 0;
  }
  bool leadsEdge(std::int32_t halfEdge) const {
    const std::int32_t twin = topology_.twin(halfEdge);
    return halfEdge < twin && (patchAt(halfEdge) >= 0 || patchAt(twin) >= 0);
  }

  std::int64_t edgePoints() const { return pieces_ - 1; }
  std::int64_t insidePoints() const { return std::int64_t{pieces_ - 1} * (pieces_ - 2) / 2; }
  std::int64_t firstEdgePoint() const { return static_cast<std::int64_t>(runStarts_.size()); }
  std::int64_t firstInsidePoint() const { return firstEdgePoint() + edgeCount_ * edgePoints(); }
  std::int64_t vertexCount() const { return firstInsidePoint() + patches_.patchCount() * insidePoints(); }

  Result<void> checkSize() const {
    constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();
    const std::int64_t corners = std::int64_t{3} * pieces_ * pieces_ * patches_.patchCount();
    if (vertexCount() <= kMost && corners <= kMost) return {};
    return fail(ErrorCode::tooLarge,
                fmt::format("{} patches cut into {} pieces an edge make {} vertices and {} triangles, too many for "
                            "32-bit numbers; cut them into fewer",
                            patches_.patchCount(), pieces_, vertexCount(), corners / 3));
  }

  /// Numbers the runs of face f from firstRun on.
  /// A face whose corners all have patches is one run.
  void placeFaceCorners(std::int32_t f, std::int32_t firstRun) {
    const std::int32_t begin = topology_.faceOffsets()[at(f)];
    const std::int32_t end = topology_.faceOffsets()[at(f) + 1];
    std::int32_t first = begin;
    while (first < end && !startsRun(first)) ++first;
    if (first == end) first = begin;
    if (patchAt(first) < 0) return;
    std::int32_t run = firstRun - 1;
    std::int32_t h = first;
    do {
      if (h == first || startsRun(h)) runStarts_[at(++run)] = h;
      if (patchAt(h) >= 0) cornerVertex_[at(h)] = run;
      h = topology_.next(h);
    } while (h != first);
  }

  std::int32_t countRuns(std::int32_t f) const {
    const std::int32_t begin = topology_.faceOffsets()[at(f)];
    std::int32_t runs = 0;
    for (std::int32_t h = begin; h < topology_.faceOffsets()[at(f) + 1]; ++h) runs += startsRun(h) ? 1 : 0;
    return runs == 0 && patchAt(begin) >= 0 ? 1 : runs;
  }

  void placeCorners() {
    std::vector<std::int32_t> firstRun(at(topology_.faceCount()));
    Parallel::forEach(0, topology_.faceCount(),
                      [&](std::int64_t f) { firstRun[at(f)] = countRuns(static_cast<std::int32_t>(f)); });
    runStarts_.resize(at(Parallel::exclusiveScan(firstRun)));
    cornerVertex_.assign(at(topology_.halfEdgeCount()), -1);
    Parallel::forEach(0, topology_.faceCount(),
                      [&](std::int64_t f) { placeFaceCorners(static_cast<std::int32_t>(f), firstRun[at(f)]); });
  }

  void placeEdges() {
    edgeRank_.resize(at(topology_.halfEdgeCount()));
    Parallel::forEach(0, topology_.halfEdgeCount(),
                      [&](std::int64_t h) { edgeRank_[at(h)] = leadsEdge(static_cast<std::int32_t>(h)) ? 1 : 0; });
    edgeCount_ = Parallel::exclusiveScan(edgeRank_);
  }

  /// Which corner of its vertex's patch the face of a half-edge has.
  std::size_t cornerOf(std::int32_t halfEdge) const {
    const std::array<std::int32_t, 3> h = patches_.patch(patchAt(halfEdge)).halfEdges();
    return at(std::find(h.begin(), h.end(), halfEdge) - h.begin());
  }

  void sampleCorners() {
    Parallel::forEach(0, firstEdgePoint(), [&](std::int64_t i) {
      const std::int32_t h = runStarts_[at(i)];
      PatchSample& sample = result_.samples[at(i)];
      sample.patch = patchAt(h);
      sample.barycentric[cornerOf(h)] = 1;
    });
  }

  double part(std::int64_t k) const { return static_cast<double>(k) / static_cast<double>(pieces_); }

  /// Point k of the edge of leader h lies k pieces from the corner in twin(h)'s face on the way to that in h's.
  PatchSample edgeSample(std::int32_t h, std::int64_t k) const {
    PatchSample sample;
    if (patchAt(h) < 0) {
      h = topology_.twin(h);
      k = pieces_ - k;
    }
    const std::size_t corner = cornerOf(h);
    sample.patch = patchAt(h);
    sample.barycentric[corner] = part(k);
    sample.barycentric[(corner + 2) % 3] = part(pieces_ - k);
    return sample;
  }

  void sampleEdges() {
    Parallel::forEach(0, topology_.halfEdgeCount(), [&](std::int64_t i) {
      const auto h = static_cast<std::int32_t>(i);
      if (!leadsEdge(h)) return;
      for (std::int64_t k = 1; k < pieces_; ++k) result_.samples[at(edgeVertex(h, k))] = edgeSample(h, k);
    });
  }

  void sampleInsides() {
    Parallel::forEach(0, patches_.patchCount(), [&](std::int64_t patch) {
      std::size_t vertex = at(firstInsidePoint() + patch * insidePoints());
      for (std::int64_t r = 2; r < pieces_; ++r) {
        for (std::int64_t c = 1; c < r; ++c) {
          result_.samples[vertex++] = {static_cast<std::int32_t>(patch), {part(pieces_ - r), part(r - c), part(c)}};
        }
      }
    });
  }

  /// Point k of the edge that a patch has across half-edge h of its vertex, counted as in edgeSample.
  std::int64_t edgeVertex(std::int32_t h, std::int64_t k) const {
    const std::int32_t twin = topology_.twin(h);
    if (twin < h) return edgeVertex(twin, pieces_ - k);
    return firstEdgePoint() + edgeRank_[at(h)] * edgePoints() + k - 1;
  }

  /// The vertex in row r, column c of the grid of a patch with the half-edges h.
  std::int32_t gridVertex(std::int32_t patch, const std::array<std::int32_t, 3>& h, std::int64_t r,
                          std::int64_t c) const {
    if (r == 0) return cornerVertex_[at(h[0])];
    if (r == pieces_ && c == 0) return cornerVertex_[at(h[1])];
    if (r == pieces_ && c == pieces_) return cornerVertex_[at(h[2])];
    std::int64_t vertex = firstInsidePoint() + patch * insidePoints() + (r - 1) * (r - 2) / 2 + c - 1;
    if (c == 0) vertex = edgeVertex(h[1], r);
    if (r == pieces_) vertex = edgeVertex(h[2], c);
    if (c == r) vertex = edgeVertex(h[0], pieces_ - r);
    return static_cast<std::int32_t>(vertex);
  }

  void writePatchTriangles(std::int32_t patch) {
    const std::array<std::int32_t, 3> h = patches_.patch(patch).halfEdges();
    const auto vertex = [&](std::int64_t r, std::int64_t c) { return gridVertex(patch, h, r, c); };
    std::size_t corner = at(3 * std::int64_t{patch} * pieces_ * pieces_);
    const auto add = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
      for (const std::int32_t v : {a, b, c}) result_.polygons.indices[corner++] = v;
    };
    for (std::int64_t r = 0; r < pieces_; ++r) {
      for (std::int64_t c = 0; c <= r; ++c) {
        add(vertex(r, c), vertex(r + 1, c), vertex(r + 1, c + 1));
        if (c < r) add(vertex(r, c), vertex(r + 1, c + 1), vertex(r, c + 1));
      }
    }
  }

  void writeTriangles() {
    const std::int64_t triangles = std::int64_t{patches_.patchCount()} * pieces_ * pieces_;
    result_.polygons.indices.resize(at(3 * triangles));
    result_.polygons.faceOffsets.resize(at(triangles + 1));
    Parallel::forEach(0, triangles + 1, [&](std::int64_t i) { result_.polygons.faceOffsets[at(i)] = 3 * i; });
    constexpr std::int64_t kPatchGrain = 64;
    Parallel::forEach(
        0, patches_.patchCount(), [&](std::int64_t p) { writePatchTriangles(static_cast<std::int32_t>(p)); },
        kPatchGrain);
  }

  const PatchTable& patches_;
  const Topology& topology_;
  std::int64_t pieces_;
  std::vector<std::int32_t> runStarts_;     // per corner vertex: the first half-edge of its run
  std::vector<std::int32_t> cornerVertex_;  // per half-edge: the vertex at the corner of its face
  std::vector<std::int32_t> edgeRank_;      // per half-edge that leads an edge of patches: its number
  std::int64_t edgeCount_ = 0;
  Tessellation result_;
};

}  // namespace

Result<Tessellation> PatchTable::tessellate(std::int32_t pieces) const {
  if (pieces < 1 || pieces > kMostPieces)
    return fail(ErrorCode::invalidOption,
                fmt::format("patches can't be cut into {} pieces an edge; take 1 to {}", pieces, kMostPieces));
  return Tessellator(*this, pieces).run();
}

}  // namespace honeycomb::Far
