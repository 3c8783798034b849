// Faces of N sides, all of whose matrices have the form SHAPE: EVOLVE brings a face's points to the next level, WRITE
// writes those of the wanted level, KEEP keeps those of a level before, FACES runs a step. Included once for each kind;
// the order of operations is that of far/tables/level_table.h.
//     record   (N+1)/2 words of two corners each, then the first output; whole texels
#define TEXELS (((N + 1) / 2 + 4) / 4)
#if SHAPE == SHAPE_QUAD || SHAPE == SHAPE_HEXAGON
#define WEIGHT_TEXELS 1
#else
#define WEIGHT_TEXELS ((N + 3) / 4)
#endif

void EVOLVE(inout vec4 p[N], const vec4 w[WEIGHT_TEXELS]) {
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

void WRITE(uint first, const vec4 p[N]) {
#if N % 4 == 0
  if (kPlacing == kFours) {
    for (int i = 0; i < N; i += 4) writeFour(first + uint(i), p[i], p[i + 1], p[i + 2], p[i + 3]);
    return;
  }
#elif N == 6
  if (kPlacing == kFours) {
    writeSix(first, p);
    return;
  }
#endif
#if N % 2 == 0
  if (kPlacing == kPairs || kPlacing == kSixes || kPlacing == kEights) {
    const uint pair = firstPair + first / 2u;
    for (int i = 0; i < N; i += 2) writePair(pair + uint(i / 2), p[i], p[i + 1]);
    return;
  }
#endif
  for (int i = 0; i < N; ++i) writePoint(first + uint(i), p[i]);
}

// The points of a stage begin at an even one (osd/vulkan/tile_image.h).
void KEEP(uint first, const vec4 p[N]) {
#if N % 2 == 0
  const uint pair = pairOf(first);
  for (int i = 0; i < N; i += 2) keepPair(pair + uint(i / 2), p[i], p[i + 1]);
#else
  for (int i = 0; i < N; ++i) keepPoint(first + uint(i), p[i]);
#endif
}

// Weights are fetched once for all faces where they can be: a fetch costs lavapipe as much as evolving a face.
#define FETCH_WEIGHTS(first) \
  for (int i = 0; i < WEIGHT_TEXELS; ++i) w[i] = weightsAt((first) + uint(i))

void FACES(Step step, const uint stages) {
  uint face = gl_LocalInvocationID.x;
  if (face >= step.count) return;
  vec4 w[WEIGHT_TEXELS];
  const uvec4 firstStage = texelFetch(table, int(step.firstStage));
  FETCH_WEIGHTS(firstStage.y);
  do {
    uvec4 record[TEXELS];
    for (int i = 0; i < TEXELS; ++i) record[i] = texelFetch(table, int(step.firstRecord + face * TEXELS) + i);
    vec4 p[N];
    for (int i = 0; i < N; ++i) p[i] = ownPoint(halfOf(record[i / 8][i / 2 % 4], uint(i)));
    uint s = 0u;
    if (stages != kWritten) {
      uint kept = firstStage.x + face * N;
      do {
        if (!kSameWeights) FETCH_WEIGHTS(texelFetch(table, int(step.firstStage + s)).y);
        EVOLVE(p, w);
        KEEP(kept, p);
        kept += firstStage.z;
        ++s;
      } while (s < step.kept);
    }
    if (stages == kBoth && !kSameWeights) FETCH_WEIGHTS(texelFetch(table, int(step.firstStage + s)).y);
    if (stages == kBoth || stages == kWritten) EVOLVE(p, w);
    if (stages != kKept) WRITE(record[(N + 1) / 2 / 4][(N + 1) / 2 % 4], p);
    face += gl_WorkGroupSize.x;
  } while (face < step.count);
}

#undef TEXELS
#undef FETCH_WEIGHTS
#undef WEIGHT_TEXELS
#undef N
#undef SHAPE
#undef EVOLVE
#undef WRITE
#undef KEEP
#undef FACES
