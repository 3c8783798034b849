#version 450
#extension GL_GOOGLE_include_directive : require
// Keys and what goes with them, sorted stably by one digit: one invocation a piece; push.value keys in all. The lowest
// digit is the first to be sorted by, when everything is in its own place still.
#include "connectivity.glsl"

layout(set = 0, binding = 1) restrict readonly buffer Keys { uint keys[]; };
layout(set = 0, binding = 2) restrict readonly buffer Order { uint order[]; };
layout(set = 0, binding = 3) restrict readonly buffer Places { uint places[]; };
layout(set = 0, binding = 4) restrict writeonly buffer SortedKeys { uint sortedKeys[]; };
layout(set = 0, binding = 5) restrict writeonly buffer SortedOrder { uint sortedOrder[]; };

void main() {
  const uint piece = invocation();
  if (piece >= push.count) return;
  uint place[kBins];
  for (uint d = 0u; d < kBins; ++d) place[d] = places[d * push.count + piece];
  const uint end = min((piece + 1u) * kPiece, push.value);
  for (uint i = piece * kPiece; i < end; ++i) {
    const uint digit = (keys[i] >> push.shift) & (kBins - 1u);
    const uint to = place[digit]++;
    sortedKeys[to] = keys[i];
    sortedOrder[to] = push.shift == 0u ? i : order[i];
  }
}
