#include <algorithm>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/conversions/conversion_parts.h"
#include "far/conversions/conversions.h"
#include "far/conversions/scheme_step.h"
#include "far/schemes/akleman.h"
#include "far/topology/three_valent.h"

namespace honeycomb::Far {
namespace {

bool allTriangles(const Topology& topology) {
  return std::all_of(topology.runs().begin(), topology.runs().end(), [](const FaceRun& run) { return run.sides == 3; });
}

/// Faces of the dual have three sides or more, and there are any.
bool hasDual(const Topology& topology) {
  bool inside = false;
  for (std::int32_t v = 0; v < topology.vertexCount(); ++v) {
    if (topology.onBoundary(v)) continue;
    if (topology.facesAt(v) < 3) return false;
    inside = true;
  }
  return inside;
}

Conversion unchanged(const Topology& topology) {
  const CallerFaces faces(topology);
  Conversion result;
  result.sourceCount = topology.vertexCount();
  result.polygons.vertexCount = topology.vertexCount();
  result.polygons.corners = taggedCorners(topology);
  layOutRows(result.rows, std::vector<std::int32_t>(at(topology.vertexCount()), 1));
  Parallel::forEach(0, topology.vertexCount(), [&](std::int64_t i) {
    const auto v = static_cast<std::int32_t>(i);
    setMean(result.rows, i, std::span(&v, 1));
  });
  for (std::int32_t f = 0; f < faces.count(); ++f) {
    const std::span<const std::int32_t> loop = faces.loop(f);
    result.polygons.addFace({loop.begin(), loop.end()});
    result.faceSources.push_back({FaceParent::face, f});
  }
  return result;
}

}  // namespace

Result<Conversion> hexagonal(const Topology& topology) {
  if (firstNotThreeValent(topology) < 0) return unchanged(topology);
  if (allTriangles(topology) && hasDual(topology)) return dual(topology);
  const Result<Scheme> scheme = akleman();
  if (!scheme) return tl::unexpected(scheme.error());
  return schemeStep(topology, *scheme);
}

}  // namespace honeycomb::Far
