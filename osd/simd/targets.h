#pragma once

/// What Highway compiles the kernels for; to be included before <hwy/foreach_target.h>: SSE4, AVX2 and AVX-512 on x86,
/// NEON on Arm, each chosen when the program runs. Vectors whose size the compiler doesn't know (SVE, RVV) can't be
/// elements of arrays; SSSE3 has nothing over SSE2 that the kernels use. Where none of them is there (HWY_SCALAR,
/// HWY_EMU128) the plain kernels do the work. HONEYCOMB_NARROW_SIMD, for quick builds: on x86 AVX2 only, and tiles with
/// kernels of their own for hexagons and schemes of quads alone, all other faces by those for any number of sides.
#ifndef HWY_DISABLED_TARGETS
#ifdef HONEYCOMB_NARROW_SIMD
#define HONEYCOMB_LEFT_OUT (HWY_SSE4 | HWY_AVX3)
#else
#define HONEYCOMB_LEFT_OUT 0
#endif
#define HWY_DISABLED_TARGETS \
  (HONEYCOMB_LEFT_OUT | HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#endif

/// Is the target of this pass over a source one with vectors? To be asked behind <hwy/highway.h>.
#define HONEYCOMB_HAS_VECTORS (HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128)
