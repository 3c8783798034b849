#version 450
#extension GL_GOOGLE_include_directive : require
// The loops of the faces that the control mesh's vertices become: one invocation a vertex, C(h) B(prev h) for each h
// that leaves it (far/topology/splits/zip_closed.cpp), and where each C(h) stands.
#include "connectivity.glsl"

layout(set = 0, binding = 1) restrict readonly buffer Outgoing { uint outgoing[]; };
layout(set = 0, binding = 2) restrict readonly buffer Around { uint around[]; };
layout(set = 0, binding = 3) restrict readonly buffer Places { uint place[]; };
layout(set = 0, binding = 4) restrict readonly buffer Twins { uint twin[]; };
layout(set = 0, binding = 5) restrict writeonly buffer Vertices { uint vert[]; };
layout(set = 0, binding = 6) restrict writeonly buffer Corners { uint corner[]; };

void main() {
  const uint v = invocation();
  if (v >= push.count) return;
  const uint begin = outgoing[v];
  if (begin == kNone) return;
  uint slot = place[v];
  uint h = begin;
  do {
    const uint next = around[h];
    vert[slot] = h;
    vert[slot + 1u] = twin[next];  // the half-edge before h
    corner[h] = slot;
    slot += 2u;
    h = next;
  } while (h != begin);
}
