#include "far/schemes/midpoint.h"

#include "far/topology/splits/ambo.h"

namespace honeycomb::Far {

Scheme midpoint() {
  Scheme scheme;
  scheme.name = "midpoint";
  scheme.split = ambo();
  scheme.entriesPerVertex = 2;
  scheme.pointRow = [](const SourceLevel& parent, const NewPoint& point, Row& row) {
    row.insert(row.end(),
               {{parent.topology().vert(point.halfEdge), 0.5}, {parent.topology().dest(point.halfEdge), 0.5}});
  };
  return scheme;
}

}  // namespace honeycomb::Far
