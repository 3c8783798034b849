// Faces of any number of sides up to kMostSides, without a kind of their own in tile_faces.glsl: rare, and so in one
// piece that is quick to compile.
const uint kMostSides = 64u;
vec4 before[kMostSides];  // the face's points at a level
vec4 after[kMostSides];

#define VALUE vec4
#define BEFORE before
#define AFTER after
#define MOST kMostSides
#define SIDES n
#define WEIGHT(k) weightAt(weights, k)
void evolveAnyDirect(uint n, uint weights) {
#define SHAPE SHAPE_DIRECT
#include "circulant_form.glsl"
#undef SHAPE
}

void evolveAnyEvenOdd(uint n, uint weights) {
#define SHAPE SHAPE_EVEN_ODD
#include "circulant_form.glsl"
#undef SHAPE
}
#undef VALUE
#undef BEFORE
#undef AFTER
#undef MOST
#undef SIDES
#undef WEIGHT

void facesAnySides(Step step) {
  const uint n = step.width;
  const uint words = (n + 1u) / 2u;
  for (uint face = gl_LocalInvocationID.x; face < step.count; face += gl_WorkGroupSize.x) {
    const uint record = step.firstRecord + face * ((words + 4u) / 4u);
    const uint first = texelFetch(table, int(record + words / 4u))[words % 4u];
    for (uint i = 0u; i < n; ++i) {
      after[i] = ownPoint(halfOf(texelFetch(table, int(record + i / 8u))[i / 2u % 4u], i));
    }
    const uint stages = step.written == 1u ? step.kept + 1u : step.kept;
    for (uint s = 0u; s < stages; ++s) {
      const uvec4 stage = texelFetch(table, int(step.firstStage + s));
      for (uint i = 0u; i < n; ++i) before[i] = after[i];
      if (n % 2u == 0u) {
        evolveAnyEvenOdd(n, stage.y);
      } else {
        evolveAnyDirect(n, stage.y);
      }
      const bool isWritten = step.written != 0u && s + 1u == stages;
      for (uint i = 0u; i < n; ++i) {
        if (s < step.kept) keepPoint(stage.x + face * n + i, after[i]);
        if (isWritten) writePoint(first + i, after[i]);
      }
    }
  }
}
