#version 450
#extension GL_GOOGLE_include_directive : require
// SummedRows: one invocation a row.
#include "evaluate.glsl"
#include "source.glsl"
#include "target.glsl"

layout(set = 0, binding = 1) restrict readonly buffer Indices { uint indices[]; };
layout(set = 0, binding = 2) restrict readonly buffer Weights { float weights[]; };
layout(set = 0, binding = 4) restrict readonly buffer Sums { float sums[]; };
layout(set = 0, binding = 5) restrict readonly buffer Rows { uint rows[]; };      // output, first entry, first share
layout(set = 0, binding = 6) restrict readonly buffer Shares { uvec2 shares[]; };  // number of the sum, weight's bits

float share(uint t, uint c) {
  // projected_sums writes three sums a component, S first.
  precise float value = uintBitsToFloat(shares[t].y) * sums[shares[t].x + 3u * c];
  return value;
}

void main() {
  const uint row = invocation();
  if (row >= push.count) return;
  const uint record = 3u * row;
  const uint begin = rows[record + 1u];
  const uint end = rows[record + 4u];
  const uint firstShare = rows[record + 2u];
  const uint endShare = rows[record + 5u];
  for (uint c = 0u; c < kLength; ++c) {
    uint b = begin;
    uint t = firstShare;
    precise float sum;
    if (b < end) {
      sum = weights[push.firstWeight + b] * sourceValue(indices[push.firstIndex + b], c);
      ++b;
    } else {
      sum = share(t, c);
      ++t;
    }
    for (; b < end; ++b) {
      precise float term = weights[push.firstWeight + b] * sourceValue(indices[push.firstIndex + b], c);
      sum = sum + term;
    }
    for (; t < endShare; ++t) sum = sum + share(t, c);
    writeTarget(rows[record], c, sum);
  }
}
