#include "far/schemes/centroid.h"

#include "far/topology/splits/expand.h"

namespace honeycomb::Far {

Scheme centroid() {
  Scheme scheme;
  scheme.name = "centroid";
  scheme.split = expand();
  scheme.faceRule = [](std::int32_t sides) {
    CirculantRule rule;
    rule.here = 0.5;
    rule.mean = 0.5 / sides;
    return rule;
  };
  return scheme;
}

}  // namespace honeycomb::Far
