#include "bench/kit/evaluators.h"

#include <array>

#include "bench/kit/level_evaluator.h"
#include "far/base/stopwatch.h"
#include "osd/cpu_evaluator.h"

namespace honeycomb::Bench {

namespace {

#ifndef HONEYCOMB_BENCH_VULKAN
constexpr const char* kNoVulkan = "this build has no Vulkan; configure it with -DHONEYCOMB_VULKAN=ON";
#endif
#ifndef HONEYCOMB_BENCH_OPENSUBDIV
constexpr const char* kNoOpenSubdiv = "this build has no OpenSubdiv; install libosd-dev and configure again";
#endif
#ifndef HONEYCOMB_BENCH_EIGEN
constexpr const char* kNoEigen = "this build has no Eigen; install libeigen3-dev and configure again";
#endif

#ifdef _OPENMP
constexpr Threads kOpenMp = Threads::all;
#else
constexpr Threads kOpenMp = Threads::one;
#endif

template <const char* const& Why>
Result<Prepared> absent(const Problem&) {
  return fail(ErrorCode::unsupported, Why);
}

}  // namespace

Result<const Far::StencilTable*> FlatTable::get() {
  if (!table_) {
    const Stopwatch stopwatch;
    Far::StencilOptions options;
    options.memoryLimit = memory_;
    table_ = Far::StencilTable::build(refinement_, options);
    buildMs_ = stopwatch.milliseconds();
  }
  if (!*table_) return tl::unexpected(table_->error());
  return &**table_;
}

std::span<const Layout> layouts() {
  static constexpr std::array kLayouts{Layout{"xyz", {0, 3, 3}}, Layout{"xyzw", {0, 4, 4}}};
  return kLayouts;
}

std::span<const EvaluatorEntry> evaluators() {
  static constexpr std::array kEvaluators{
      EvaluatorEntry{"serial", Agreement::bits, Threads::one, prepareLevels<Osd::SerialEvaluator>},
      EvaluatorEntry{"simd", Agreement::bits, Threads::one, prepareLevels<Osd::SimdEvaluator>},
      EvaluatorEntry{"tbb", Agreement::bits, Threads::all, prepareLevels<Osd::TbbEvaluator>},
      EvaluatorEntry{"simd-tiled", Agreement::bits, Threads::one, prepareSimdTiled},
      EvaluatorEntry{"tbb-tiled", Agreement::bits, Threads::all, prepareTbbTiled},
      EvaluatorEntry{"tbb-tile-order", Agreement::bits, Threads::all, prepareTbbTileOrder},
      EvaluatorEntry{"csr", Agreement::rounding, Threads::all, prepareCsr},
#ifdef HONEYCOMB_BENCH_VULKAN
      EvaluatorEntry{"vulkan", Agreement::bits, Threads::device, prepareVulkan},
      EvaluatorEntry{"vulkan-tiled", Agreement::bits, Threads::device, prepareVulkanTiled},
      EvaluatorEntry{"vulkan-csr", Agreement::rounding, Threads::device, prepareVulkanCsr},
#else
      EvaluatorEntry{"vulkan", Agreement::bits, Threads::device, absent<kNoVulkan>},
      EvaluatorEntry{"vulkan-tiled", Agreement::bits, Threads::device, absent<kNoVulkan>},
      EvaluatorEntry{"vulkan-csr", Agreement::rounding, Threads::device, absent<kNoVulkan>},
#endif
#ifdef HONEYCOMB_BENCH_OPENSUBDIV
      EvaluatorEntry{"opensubdiv-cpu", Agreement::rounding, Threads::one, prepareOpenSubdivCpu},
      EvaluatorEntry{"opensubdiv-omp", Agreement::rounding, Threads::all, prepareOpenSubdivOmp},
      EvaluatorEntry{"opensubdiv-catmark", Agreement::rounding, Threads::all, prepareOpenSubdivCatmark},
#else
      EvaluatorEntry{"opensubdiv-cpu", Agreement::rounding, Threads::one, absent<kNoOpenSubdiv>},
      EvaluatorEntry{"opensubdiv-omp", Agreement::rounding, Threads::all, absent<kNoOpenSubdiv>},
      EvaluatorEntry{"opensubdiv-catmark", Agreement::rounding, Threads::all, absent<kNoOpenSubdiv>},
#endif
#ifdef HONEYCOMB_BENCH_EIGEN
      EvaluatorEntry{"eigen", Agreement::rounding, kOpenMp, prepareEigen},
#else
      EvaluatorEntry{"eigen", Agreement::rounding, Threads::all, absent<kNoEigen>},
#endif
  };
  return kEvaluators;
}

Far::TileNormalKind tileNormals(Normals normals) {
  switch (normals) {
    case Normals::none:
      return Far::TileNormalKind::none;
    case Normals::fast:
      return Far::TileNormalKind::fast;
    case Normals::exact:
      break;
  }
  return Far::TileNormalKind::exact;
}

Result<void> withoutNormals(const Problem& problem) {
  if (problem.normals == Normals::none) return {};
  return fail(ErrorCode::unsupported, "has no normals of that kind");
}

}  // namespace honeycomb::Bench
