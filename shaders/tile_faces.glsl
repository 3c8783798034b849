// Faces of N sides, all of whose matrices have the form SHAPE: EVOLVE brings a face's points to the next level, FACES
// runs a step. Included once for each kind; the order of operations is that of far/tables/level_table.h.
//     record   (N+1)/2 words of two corners each, then the first output; whole texels
#define TEXELS (((N + 1) / 2 + 4) / 4)
#if SHAPE == SHAPE_QUAD || SHAPE == SHAPE_HEXAGON
#define WEIGHT_TEXELS 1
#else
#define WEIGHT_TEXELS ((N + 3) / 4)
#endif

void EVOLVE(inout vec4 p[N], uint firstWeight) {
  vec4 w[WEIGHT_TEXELS];
  for (int i = 0; i < WEIGHT_TEXELS; ++i) w[i] = weightsAt(firstWeight + uint(i));
  vec4 before[N] = p;
#define VALUE vec4
#define BEFORE before
#define AFTER p
#define MOST uint(N)
#define SIDES uint(N)
#define WEIGHT(k) w[(k) / 4u][(k) % 4u]
#include "circulant_form.glsl"
#undef VALUE
#undef BEFORE
#undef AFTER
#undef MOST
#undef SIDES
#undef WEIGHT
}

void FACES(Step step, const uint stages) {
  uint face = gl_LocalInvocationID.x;
  if (face >= step.count) return;
  do {
    uvec4 record[TEXELS];
    for (int i = 0; i < TEXELS; ++i) record[i] = texelFetch(table, int(step.firstRecord + face * TEXELS) + i);
    vec4 p[N];
    for (int i = 0; i < N; ++i) p[i] = ownPoint(halfOf(record[i / 8][i / 2 % 4], uint(i)));
    uint s = 0u;
    if (stages != kWritten) {
      do {
        const uvec4 stage = texelFetch(table, int(step.firstStage + s));
        EVOLVE(p, stage.y);
        for (int i = 0; i < N; ++i) keepPoint(stage.x + face * N + uint(i), p[i]);
        ++s;
      } while (s < step.kept);
    }
    if (stages != kKept) {
      if (stages != kAlso) EVOLVE(p, texelFetch(table, int(step.firstStage + s)).y);
      const uint first = record[(N + 1) / 2 / 4][(N + 1) / 2 % 4];
#if N % 2 == 0
      if (kPlacing == kPairs) {
        for (int i = 0; i < N; i += 2) writePair(first + uint(i), p[i], p[i + 1]);
      } else {
        for (int i = 0; i < N; ++i) writePoint(first + uint(i), p[i]);
      }
#else
      for (int i = 0; i < N; ++i) writePoint(first + uint(i), p[i]);
#endif
    }
    face += gl_WorkGroupSize.x;
  } while (face < step.count);
}

#undef TEXELS
#undef WEIGHT_TEXELS
#undef N
#undef SHAPE
#undef EVOLVE
#undef FACES
