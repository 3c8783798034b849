#version 450
#extension GL_GOOGLE_include_directive : require
// What stands before each number, summed; push.value numbers in all. One invocation a piece; `before` has the same of
// the pieces' sums, unless there is one piece alone.
#include "connectivity.glsl"

layout(set = 0, binding = 1) restrict readonly buffer Numbers { uint numbers[]; };
layout(set = 0, binding = 2) restrict readonly buffer Before { uint before[]; };
layout(set = 0, binding = 3) restrict writeonly buffer Scanned { uint scanned[]; };

void main() {
  const uint piece = invocation();
  if (piece >= push.count) return;
  uint sum = push.count > 1u ? before[piece] : 0u;
  const uint end = min((piece + 1u) * kPiece, push.value);
  for (uint i = piece * kPiece; i < end; ++i) {
    scanned[i] = sum;
    sum += numbers[i];
  }
}
