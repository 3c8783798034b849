#include "far/tables/level_table.h"

#include "far/base/bytes.h"
#include "far/tables/limit_table.h"

namespace honeycomb::Far {

std::int64_t LevelTable::byteCount() const {
  return bytes(circulants) + bytes(projected) + bytes(dense) + bytes(loose.outputs) + bytes(loose.offsets) +
         bytes(summed.rows.outputs) + bytes(summed.rows.offsets) + bytes(summed.shareOffsets) + bytes(summed.faces) +
         bytes(indices) + bytes(weights) + bytes(weightsSingle);
}

std::int64_t LimitRows::byteCount() const {
  return bytes(batches) + bytes(elements) + bytes(indices) + bytes(weights) + bytes(weightsSingle);
}

std::int64_t LimitTable::byteCount() const {
  return faces.byteCount() + child.byteCount() + vertices.byteCount() + verticesHere.byteCount();
}

}  // namespace honeycomb::Far
