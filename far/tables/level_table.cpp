#include "far/tables/level_table.h"

#include "far/base/bytes.h"
#include "far/tables/limit_table.h"

namespace honeycomb::Far {

std::int64_t LevelTable::byteCount() const {
  return byteSize(circulants) + byteSize(projected) + byteSize(dense) + byteSize(loose.outputs) +
         byteSize(loose.offsets) + byteSize(indices) + byteSize(weights) + byteSize(weightsSingle);
}

std::int64_t LimitRows::byteCount() const {
  return byteSize(batches) + byteSize(elements) + byteSize(indices) + byteSize(weights) + byteSize(weightsSingle);
}

std::int64_t LimitTable::byteCount() const {
  return faces.byteCount() + child.byteCount() + vertices.byteCount() + verticesHere.byteCount();
}

}  // namespace honeycomb::Far
