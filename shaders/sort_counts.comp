#version 450
#extension GL_GOOGLE_include_directive : require
// How often each digit is in each piece of the keys; push.value keys in all. By digit, then by piece, so that what
// stands before a count is where its keys go.
#include "connectivity.glsl"

layout(set = 0, binding = 1) restrict readonly buffer Keys { uint keys[]; };
layout(set = 0, binding = 2) restrict writeonly buffer Counts { uint counts[]; };

void main() {
  const uint piece = invocation();
  if (piece >= push.count) return;
  uint found[kBins];
  for (uint d = 0u; d < kBins; ++d) found[d] = 0u;
  const uint end = min((piece + 1u) * kPiece, push.value);
  for (uint i = piece * kPiece; i < end; ++i) ++found[(keys[i] >> push.shift) & (kBins - 1u)];
  for (uint d = 0u; d < kBins; ++d) counts[d * push.count + piece] = found[d];
}
