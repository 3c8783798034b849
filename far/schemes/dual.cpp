#include "far/schemes/dual.h"

#include "far/topology/splits/dual.h"

namespace honeycomb::Far {

Scheme dualStep() {
  Scheme scheme;
  scheme.name = "dual";
  scheme.split = dualSplit();
  scheme.entriesPerVertex = 4;
  scheme.pointRow = [](const SourceLevel& parent, const NewPoint& point, Row& row) {
    parent.addBarycentre(parent.topology().face(point.halfEdge), 1, row);
  };
  return scheme;
}

}  // namespace honeycomb::Far
