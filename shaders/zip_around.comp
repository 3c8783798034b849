#version 450
#extension GL_GOOGLE_include_directive : require
// Per half-edge of the control mesh: the next one counter-clockwise round its vertex, and what is wrong with it.
#include "connectivity.glsl"

layout(set = 0, binding = 1) restrict readonly buffer Vertices { uint vert[]; };
layout(set = 0, binding = 2) restrict readonly buffer Twins { uint twin[]; };
layout(set = 0, binding = 3) restrict readonly buffer Offsets { uint offsets[]; };
layout(set = 0, binding = 4) restrict readonly buffer Faces { uint face[]; };
layout(set = 0, binding = 5) restrict writeonly buffer Around { uint around[]; };
layout(set = 0, binding = 6) restrict writeonly buffer Defects { uint defects[]; };

bool soundLoop(uint f) {
  const uint begin = offsets[f];
  const uint end = offsets[f + 1u];
  return begin < end && end - begin >= 3u && end <= push.halfEdges && (f > 0u || begin == 0u) &&
         (f + 1u < push.faces || end == push.halfEdges);
}

uint edgeDefect(uint h, uint next) {
  const uint t = twin[h];
  if (int(t) < 0) return kOpenDefect;
  if (t >= push.halfEdges || t == h || twin[t] != h || vert[t] != vert[next]) return kTwinDefect;
  return 0u;
}

void main() {
  const uint h = invocation();
  if (h >= push.count) return;
  const uint f = face[h];
  const uint begin = offsets[f];
  const uint end = offsets[f + 1u];
  // Of faces without half-edges, too: there are fewer faces than half-edges.
  if (!soundLoop(f) || h < begin || h >= end || (h < push.faces && !soundLoop(h))) {
    around[h] = kNone;
    defects[h] = defectOf(h, kFaceDefect);
    return;
  }
  const uint before = h == begin ? end - 1u : h - 1u;
  const uint next = h + 1u == end ? begin : h + 1u;
  around[h] = vert[h] < push.vertices && edgeDefect(before, h) == 0u ? twin[before] : kNone;
  defects[h] = defectOf(h, vert[h] >= push.vertices ? kVertexDefect : edgeDefect(h, next));
}
