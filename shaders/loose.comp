#version 450
#extension GL_GOOGLE_include_directive : require
// LooseRows: one invocation a row.
#include "evaluate.glsl"
#include "source.glsl"
#include "target.glsl"

layout(set = 0, binding = 1) restrict readonly buffer Indices { uint indices[]; };
layout(set = 0, binding = 2) restrict readonly buffer Weights { float weights[]; };
layout(set = 0, binding = 5) restrict readonly buffer Outputs { uint outputs[]; };
layout(set = 0, binding = 6) restrict readonly buffer Offsets { uint offsets[]; };

void main() {
  const uint row = invocation();
  if (row >= push.count) return;
  const uint begin = offsets[push.firstTask + row];
  const uint end = offsets[push.firstTask + row + 1u];
  const uint point = outputs[push.firstRecord + row];
  for (uint c = 0u; c < kLength; ++c) {
    precise float sum = weights[push.firstWeight + begin] * sourceValue(indices[push.firstIndex + begin], c);
    for (uint b = begin + 1u; b < end; ++b) {
      precise float term = weights[push.firstWeight + b] * sourceValue(indices[push.firstIndex + b], c);
      sum = sum + term;
    }
    writeTarget(point, c, sum);
  }
}
