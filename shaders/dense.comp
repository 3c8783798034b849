#version 450
#extension GL_GOOGLE_include_directive : require
// DenseRows: one invocation a row, kSides points in, weights as push constants.
#include "evaluate.glsl"
#include "source.glsl"
#include "target.glsl"

layout(set = 0, binding = 1) restrict readonly buffer Indices { uint indices[]; };

void main() {
  const uint row = invocation();
  if (row >= push.count) return;
  const uint first = push.firstIndex + row * kSides;
  for (uint c = 0u; c < kLength; ++c) {
    precise float sum = push.weights[0] * sourceValue(indices[first], c);
    for (uint j = 1u; j < kSides; ++j) {
      precise float term = push.weights[j & 15u] * sourceValue(indices[first + j], c);
      sum = sum + term;
    }
    writeTarget(push.firstOutput + row, c, sum);
  }
}
