#version 450
#extension GL_GOOGLE_include_directive : require
// The sum of each piece of numbers; push.value numbers in all.
#include "connectivity.glsl"

layout(set = 0, binding = 1) restrict readonly buffer Numbers { uint numbers[]; };
layout(set = 0, binding = 2) restrict writeonly buffer Sums { uint sums[]; };

void main() {
  const uint piece = invocation();
  if (piece >= push.count) return;
  uint sum = 0u;
  const uint end = min((piece + 1u) * kPiece, push.value);
  for (uint i = piece * kPiece; i < end; ++i) sum += numbers[i];
  sums[piece] = sum;
}
