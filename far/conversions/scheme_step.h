#pragma once

#include "far/base/result.h"
#include "far/conversions/conversion.h"
#include "far/schemes/scheme.h"
#include "far/topology/topology.h"

namespace honeycomb::Far {

/// One step of a scheme without central control vertices as a conversion: the refined level's polygons in its order,
/// the rows of its level table.
/// Errors: those of refine(); tooLarge also when the rows would take more than kMaxRowEntries entries.
Result<Conversion> schemeStep(const Topology& topology, const Scheme& scheme);

}  // namespace honeycomb::Far
