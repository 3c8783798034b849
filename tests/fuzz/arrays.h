#pragma once

#include <cstdint>
#include <vector>

#include "capi/include/honeycomb.h"
#include "tests/fuzz/targets.h"

namespace honeycomb::Fuzz {

/// What the C API is called with, made of bytes, most of which say something wrong:
///     | scheme 1 | levels 2 bits, normals 2, tiles, limits, central points, order | option 1 | lies 1 | vertices 1 |
///     faces 1 | creases 1 | corners 1 | a size a face | the corners of all faces | two ends and 8 x the sharpness of
///     each crease | tagged corners | floats: the control points, from the first one on again where they are too few
/// All numbers but the floats are signed bytes; those behind the end are 0. Arrays have exactly the sizes the API is
/// told, so that the address sanitizer sees a read past their ends.
struct ArrayCall {
  explicit ArrayCall(Bytes bytes);

  hc_polygons polygons() const;
  hc_tables_options options() const;

  std::int8_t scheme, build, option, lies;
  std::int32_t vertexCount;
  std::vector<std::int32_t> sizes, indices, corners;
  std::vector<std::int64_t> offsets;
  std::vector<hc_crease> creases;
  std::vector<float> points;  ///< at least one
};

}  // namespace honeycomb::Fuzz
