#include "far/schemes/doo_sabin.h"

#include "far/topology/splits/expand.h"

namespace honeycomb::Far {

CirculantRule dooSabinRule(std::int32_t sides) {
  CirculantRule rule;
  rule.here = 0.25;
  rule.mean = 0.75 / sides;
  rule.cosine = 0.5 / sides;
  return rule;
}

Scheme dooSabin() {
  Scheme scheme;
  scheme.name = "doo-sabin";
  scheme.split = expand();
  scheme.faceRule = dooSabinRule;
  return scheme;
}

}  // namespace honeycomb::Far
