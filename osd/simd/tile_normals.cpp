#include "osd/simd/targets.h"
#include "osd/simd/tiles.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "osd/simd/tile_normals.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#if HONEYCOMB_HAS_VECTORS
#include "osd/simd/sinks-inl.h"
#include "osd/simd/tile_limits-inl.h"
#include "osd/simd/tile_normals-inl.h"
#endif

HWY_BEFORE_NAMESPACE();
namespace honeycomb::Osd::Simd::HWY_NAMESPACE {

void evaluateTileNormals(const Far::TileTable& table, std::int32_t tile, const float* points,
                         const Kernels::NormalViews<float>& views) {
#if HONEYCOMB_HAS_VECTORS
  const bool exact = table.normalKind == Far::TileNormalKind::exact;
  if (!exact) faceNormals(table, tile, points, views);
  if (exact && views.points.data != nullptr) {
    Stream none(nullptr);
    const auto packed = [&](const View<float>& target) HWY_ATTR { return Sink<3, false>(target, 3, none); };
    limitNormals(table, tile, points, packed(views.target), packed(views.points));
    return;
  }
  withSmallSink(views.target, 3, views.stream, [&](auto sink) HWY_ATTR {
    exact ? limitNormals(table, tile, points, sink, NoSink{})
          : vertexNormals(table, table.tiles[at(tile)], views, sink);
  });
#else
  Kernels::evaluateTileNormals(table, tile, points, views);
#endif
}

}  // namespace honeycomb::Osd::Simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace honeycomb::Osd::Simd {

HWY_EXPORT(evaluateTileNormals);

void evaluateTileNormals(const Far::TileTable& table, std::int32_t tile, const float* points,
                         const Kernels::NormalViews<float>& views) {
  HWY_DYNAMIC_DISPATCH(evaluateTileNormals)(table, tile, points, views);
}

}  // namespace honeycomb::Osd::Simd
#endif
