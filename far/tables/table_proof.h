#pragma once

#include <cstdint>
#include <span>

#include "far/base/result.h"
#include "far/tables/level_table.h"
#include "far/tables/limit_table.h"

/// Proofs that no evaluator leaves the arrays of a table, or of its points, whatever stands in it: for tables that come
/// from somewhere else, such as a file; and that the time and memory of evaluating it are in proportion to its size.
/// That each point is written once, and that weights make sense, is not proven.
///
/// A proof is two steps. The shape is what follows from batches and sizes: in time linear in the batches, without a
/// look at the long arrays. The indices are these: linear, in parallel, as fast as memory is read; of a table whose
/// shape is proven.
///
/// All errors are invalidFile: what is wrong and where, counted from 0.
namespace honeycomb::Far {

/// Do `count` elements from `first` on lie within `size`?
constexpr bool liesWithin(std::int64_t first, std::int64_t count, std::int64_t size) {
  return first >= 0 && count >= 0 && count <= size && first <= size - count;
}

/// The first of `values` that isn't in [0, end); -1 if all are. Parallel.
std::int64_t firstOutside(std::span<const std::int32_t> values, std::int32_t end);

/// The first of `offsets` that isn't in [0, end], or isn't at least `step` more than the one before; -1 if all are.
/// Parallel.
std::int64_t firstNotAscending(std::span<const std::int32_t> offsets, std::int32_t step, std::int64_t end);

/// Is that how a face of so many sides is evaluated? See CirculantForm.
bool isFormOf(CirculantForm form, std::int32_t sides);

Result<void> proveShape(const LevelTable& table);
Result<void> proveIndices(const LevelTable& table);
Result<void> proveShape(const LimitRows& rows);
/// Of rows that read `points` points and write `elements` results.
Result<void> proveIndices(const LimitRows& rows, std::int32_t points, std::int32_t elements);

/// Of limits that read `points` points, of a level with that many; empty limits are sound too.
Result<void> proveShape(const LimitTable& limits, std::int32_t points);
Result<void> proveIndices(const LimitTable& limits);

}  // namespace honeycomb::Far
