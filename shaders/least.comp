#version 450
#extension GL_GOOGLE_include_directive : require
// The least of each piece of numbers; push.value numbers in all.
#include "connectivity.glsl"

layout(set = 0, binding = 1) restrict readonly buffer Numbers { uint numbers[]; };
layout(set = 0, binding = 2) restrict writeonly buffer Least { uint least[]; };

void main() {
  const uint piece = invocation();
  if (piece >= push.count) return;
  uint found = kNone;
  const uint end = min((piece + 1u) * kPiece, push.value);
  for (uint i = piece * kPiece; i < end; ++i) found = min(found, numbers[i]);
  least[piece] = found;
}
