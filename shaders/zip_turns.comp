#version 450
#extension GL_GOOGLE_include_directive : require
// Per half-edge of the control mesh: is it the lowest that leaves its vertex? That one walks round it and counts.
#include "connectivity.glsl"

layout(set = 0, binding = 1) restrict readonly buffer Vertices { uint vert[]; };
layout(set = 0, binding = 2) restrict readonly buffer Around { uint around[]; };
layout(set = 0, binding = 3) restrict writeonly buffer Outgoing { uint outgoing[]; };
layout(set = 0, binding = 4) restrict writeonly buffer Valences { uint valence[]; };
layout(set = 0, binding = 5) restrict writeonly buffer Defects { uint defects[]; };

// Half-edges round the vertex of h; 0 where a lower one has been met, or one with a defect; more than push.most: many.
uint turn(uint h) {
  uint g = h;
  for (uint n = 1u; n <= push.most; ++n) {
    g = around[g];
    if (g == h) return n;
    if (g == kNone || g < h) return 0u;
  }
  return push.most + 1u;
}

void main() {
  const uint h = invocation();
  if (h >= push.count) return;
  const uint n = turn(h);
  if (n > 0u && n <= push.most) {
    outgoing[vert[h]] = h;
    valence[vert[h]] = n;
  }
  defects[push.halfEdges + h] = defectOf(h, n > push.most ? kValenceDefect : 0u);
}
