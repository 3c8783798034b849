#version 450
#extension GL_GOOGLE_include_directive : require
// The face of each half-edge, by bisection of the faces' first half-edges: one invocation a half-edge. Of the control
// mesh (push.value 1) its first half-edges are copied as well, and its vertices get their first values. Are the half-edges of all faces as
// many as there are? 1 yes, 2 no: the vertices of the control mesh have fewer or more than one turn of half-edges each.
#include "connectivity.glsl"

layout(set = 0, binding = 1) restrict readonly buffer Offsets { uint offsets[]; };
layout(set = 0, binding = 2) restrict writeonly buffer Faces { uint face[]; };
layout(set = 0, binding = 3) restrict writeonly buffer Copied { uint copied[]; };
layout(set = 0, binding = 4) restrict writeonly buffer Valences { uint valence[]; };
layout(set = 0, binding = 5) restrict writeonly buffer Complete { uint complete; };
layout(set = 0, binding = 6) restrict writeonly buffer Outgoing { uint outgoing[]; };

void main() {
  const uint i = invocation();
  if (i >= push.count) return;
  const bool control = push.value == 1u;
  uint below = control ? 0u : push.faces;
  uint above = control ? push.faces : push.faces + push.vertices;
  if (i == 0u) complete = offsets[above] == (control ? 1u : 3u) * push.halfEdges ? 1u : 2u;
  const uint h = push.first + i;
  if (control) {
    if (i <= push.faces) copied[i] = offsets[i];
    if (i < push.vertices) {
      valence[i] = 0u;
      outgoing[i] = kNone;
    }
  }
  while (above - below > 1u) {
    const uint middle = (below + above) / 2u;
    if (offsets[middle] <= h) {
      below = middle;
    } else {
      above = middle;
    }
  }
  face[h] = below;
}
