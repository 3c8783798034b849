// Faces of N sides, all of whose matrices have the form SHAPE: EVOLVE brings a face's points to the next level, FACES
// runs a step. Included once for each kind; the order of operations is that of far/tables/level_table.h.
//     record   (N+1)/2 words of two corners each, then the first output; whole texels
#define TEXELS (((N + 1) / 2 + 4) / 4)
#define WEIGHT_TEXELS ((N + 3) / 4)
#define HALF (N / 2)

void EVOLVE(inout vec4 p[N], uint firstWeight) {
#if SHAPE == SHAPE_QUAD
  const vec4 w = weightsAt(firstWeight);
  precise vec4 q0 = p[0] + p[2], q1 = p[1] + p[3];
  precise vec4 d0 = p[0] - p[2], d1 = p[1] - p[3];
  precise vec4 s = w.x * (q0 + q1);
  precise vec4 o0 = w.y * (d0 + d1);
  precise vec4 o1 = w.y * (d1 - d0);
  precise vec4 next[4] = vec4[4](s + o0, s + o1, s - o0, s - o1);
  p = next;
#elif SHAPE == SHAPE_HEXAGON
  const vec4 w = weightsAt(firstWeight);
  precise vec4 q[3];
  precise vec4 d[3];
  for (int j = 0; j < 3; ++j) {
    q[j] = p[j] + p[j + 3];
    d[j] = p[j] - p[j + 3];
  }
  precise vec4 s = w.x * ((q[0] + q[1]) + q[2]);
  precise vec4 o[3] = vec4[3](w.z * (d[0] + d[1]), w.z * (d[1] + d[2]), w.z * (d[2] - d[0]));
  for (int i = 0; i < 3; ++i) {
    precise vec4 e = s - w.y * q[(i + 2) % 3];
    precise vec4 upper = e + o[i];
    precise vec4 lower = e - o[i];
    p[i] = upper;
    p[i + 3] = lower;
  }
#elif SHAPE == SHAPE_EVEN_ODD
  vec4 w[WEIGHT_TEXELS];
  for (int i = 0; i < WEIGHT_TEXELS; ++i) w[i] = weightsAt(firstWeight + uint(i));
  precise vec4 q[HALF];
  precise vec4 d[HALF];
  for (int j = 0; j < HALF; ++j) {
    q[j] = p[j] + p[j + HALF];
    d[j] = p[j] - p[j + HALF];
  }
  for (int i = 0; i < HALF; ++i) {
    precise vec4 e = w[0].x * q[i];
    precise vec4 o = w[HALF / 4][HALF % 4] * d[i];
    for (int k = 1; k < HALF; ++k) {
      const bool wraps = i + k >= HALF;
      const int j = wraps ? i + k - HALF : i + k;
      precise vec4 even = w[k / 4][k % 4] * q[j];
      precise vec4 odd = w[(HALF + k) / 4][(HALF + k) % 4] * d[j];
      e = e + even;
      if (wraps) {
        o = o - odd;
      } else {
        o = o + odd;
      }
    }
    precise vec4 upper = e + o;
    precise vec4 lower = e - o;
    p[i] = upper;
    p[i + HALF] = lower;
  }
#else
  vec4 w[WEIGHT_TEXELS];
  for (int i = 0; i < WEIGHT_TEXELS; ++i) w[i] = weightsAt(firstWeight + uint(i));
  const vec4 q[N] = p;
  for (int i = 0; i < N; ++i) {
    precise vec4 sum = w[0].x * q[i];
    for (int k = 1; k < N; ++k) {
      precise vec4 term = w[k / 4][k % 4] * q[i + k < N ? i + k : i + k - N];
      sum = sum + term;
    }
    p[i] = sum;
  }
#endif
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
#undef HALF
#undef N
#undef SHAPE
#undef EVOLVE
#undef FACES
