#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "far/base/result.h"
#include "far/schemes/scheme.h"
#include "far/topology/polygons.h"
#include "far/topology/topology.h"

namespace honeycomb::Far {

/// Weighted rows over the vertices of a mesh, in compressed sparse row form:
///     row r = weights[b] in[indices[b]] + weights[b+1] in[indices[b+1]] + ...   b = offsets[r] .. offsets[r+1]-1
/// Every row sums to 1.
struct WeightedRows {
  std::vector<std::int64_t> offsets{0};  ///< rows + 1
  std::vector<std::int32_t> indices;
  std::vector<double> weights;
};

/// What a face of a converted mesh was made from, so that its material and groups can follow.
struct FaceSource {
  FaceParent kind = FaceParent::face;
  std::int32_t element = 0;  ///< the caller's face or vertex
  bool operator==(const FaceSource&) const = default;
};

/// What has to be added to the points that the rows give, where rows alone can't say where vertices lie: `values` are
/// those of the source, `points` those of the result, both `length` numbers a vertex.
using Correction =
    std::function<Result<void>(std::span<const double> values, std::int32_t length, std::span<double> points)>;

/// Another mesh made from a mesh: its polygons, and how the values of its vertices follow from those of the source.
struct Conversion {
  Polygons polygons;
  std::int32_t sourceCount = 0;         ///< vertices of the source
  WeightedRows rows;                    ///< one a vertex of the result
  std::vector<FaceSource> faceSources;  ///< one a face of the result
  Correction correction;                ///< empty, but of the inverse dual
  std::optional<Scheme> step;           ///< this is one step of it (what FaceVarying needs); none: of no scheme
};

/// The values of the result's vertices, `length` numbers a vertex, from those of the source's: positions (3), uv (2),
/// colours (4), anything. Sums run in the order of the rows. Linear in the rows' entries, in parallel.
/// Errors: invalidOption when `values` isn't sourceCount x length numbers or length isn't positive; those of the
/// correction.
Result<std::vector<double>> apply(const Conversion& conversion, std::span<const double> values, std::int32_t length);

}  // namespace honeycomb::Far
