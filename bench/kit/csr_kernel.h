#pragma once

#include <cstdint>

#include "far/tables/stencil_table.h"

namespace honeycomb::Bench {

/// Rows begin .. end-1 of a stencil table, in single precision. `control`: x y z w per control point; `refined`: point
/// r of 4 or 3 numbers to each row r.
struct CsrJob {
  const Far::StencilTable& table;
  const float* control;
  float* refined;
};
using CsrRows = void (*)(const CsrJob& job, std::int64_t begin, std::int64_t end);

/// The best kernel for this processor; `stride`: 4 or 3.
CsrRows csrRows(std::int32_t stride);

}  // namespace honeycomb::Bench
