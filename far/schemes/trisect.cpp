#include "far/schemes/trisect.h"

#include <fmt/format.h>

#include "far/topology/splits/truncate.h"

namespace honeycomb::Far {

Result<Scheme> trisect(const TrisectOptions& options) {
  const double ratio = options.ratio;
  if (!(ratio > 0 && ratio < 0.5)) {
    return fail(ErrorCode::invalidOption, fmt::format("ratio {} is out of range; it must lie in (0, 1/2)", ratio));
  }
  Scheme scheme;
  scheme.name = "trisect";
  scheme.split = truncate();
  scheme.entriesPerVertex = 2;
  scheme.pointRow = [ratio](const SourceLevel& parent, const NewPoint& point, Row& row) {
    const std::int32_t v = parent.topology().vert(point.halfEdge);
    const std::int32_t w = parent.topology().dest(point.halfEdge);
    const bool start = point.kind == PointKind::edgeStart;
    row.insert(row.end(), {{start ? v : w, 1 - ratio}, {start ? w : v, ratio}});
  };
  return scheme;
}

}  // namespace honeycomb::Far
