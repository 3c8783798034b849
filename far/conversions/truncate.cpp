#include "far/conversions/conversion_parts.h"
#include "far/conversions/conversions.h"
#include "far/conversions/scheme_step.h"
#include "far/schemes/trisect.h"

namespace honeycomb::Far {

Result<Conversion> truncate(const Topology& topology, double ratio) {
  const Result<Scheme> scheme = trisect({ratio});
  if (!scheme) return tl::unexpected(scheme.error());
  if (const auto sound = checkInsideVertices("the truncated mesh", topology, countFacesAt(topology)); !sound)
    return tl::unexpected(sound.error());
  return schemeStep(topology, *scheme);
}

}  // namespace honeycomb::Far
