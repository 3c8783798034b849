#pragma once

#include <opensubdiv/far/stencilTable.h>

#include <memory>

#include "far/tables/stencil_table.h"

namespace honeycomb::Osd {

/// The rows of a stencil table as OpenSubdiv's, for its evaluators on any device: stencil r gives row r, of the control
/// vertices 0 .. sourceCount-1. Errors: invalidOption for tangents of a table without.
Result<std::unique_ptr<const OpenSubdiv::Far::StencilTable>> toOpenSubdiv(
    const Far::StencilTable& table, Far::StencilWeights which = Far::StencilWeights::position);

/// OpenSubdiv's stencils (of `float` or `double`) as loose rows: point r by stencil r, of the table's control vertices.
/// The stencils must be factorised, their indices those of control vertices; those of a single level always are.
/// Errors: invalidOption, with the stencil as element, for one that has no entries or reads a vertex that isn't there.
template <class Real>
Result<Far::LevelTable> fromOpenSubdiv(const OpenSubdiv::Far::StencilTableReal<Real>& stencils);

}  // namespace honeycomb::Osd
