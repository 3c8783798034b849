// Faces of any number of sides up to kMostSides, without a kind of their own in tile_faces.glsl: rare, and so in one
// piece that is quick to compile.
const uint kMostSides = 64u;
vec4 before[kMostSides];  // the face's points at a level, or q and then d of the even/odd form
vec4 after[kMostSides];

void evolveAnyDirect(uint n, uint weights) {
  for (uint i = 0u; i < n; ++i) {
    precise vec4 sum = weightAt(weights, 0u) * before[i];
    for (uint k = 1u; k < n; ++k) {
      precise vec4 term = weightAt(weights, k) * before[i + k < n ? i + k : i + k - n];
      sum = sum + term;
    }
    after[i] = sum;
  }
}

void evolveAnyEvenOdd(uint n, uint weights) {
  const uint m = n / 2u;
  for (uint j = 0u; j < m; ++j) {
    precise vec4 q = before[j] + before[j + m];
    precise vec4 d = before[j] - before[j + m];
    before[j] = q;
    before[j + m] = d;
  }
  for (uint i = 0u; i < m; ++i) {
    precise vec4 e = weightAt(weights, 0u) * before[i];
    precise vec4 o = weightAt(weights, m) * before[i + m];
    for (uint k = 1u; k < m; ++k) {
      const bool wraps = i + k >= m;
      const uint j = wraps ? i + k - m : i + k;
      precise vec4 even = weightAt(weights, k) * before[j];
      precise vec4 odd = weightAt(weights, m + k) * before[j + m];
      e = e + even;
      if (wraps) {
        o = o - odd;
      } else {
        o = o + odd;
      }
    }
    precise vec4 upper = e + o;
    precise vec4 lower = e - o;
    after[i] = upper;
    after[i + m] = lower;
  }
}

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
