#version 450
#extension GL_GOOGLE_include_directive : require
// The faces that the control mesh's vertices become, sorted by valence: one invocation a face.
#include "connectivity.glsl"

layout(set = 0, binding = 1) restrict readonly buffer Order { uint order[]; };
layout(set = 0, binding = 2) restrict readonly buffer Valences { uint valence[]; };
layout(set = 0, binding = 3) restrict readonly buffer Corners { uint cornersBefore[]; };
layout(set = 0, binding = 4) restrict writeonly buffer Parents { uint parents[]; };
layout(set = 0, binding = 5) restrict writeonly buffer Offsets { uint offsets[]; };
layout(set = 0, binding = 6) restrict writeonly buffer Places { uint place[]; };

void main() {
  const uint i = invocation();
  if (i >= push.count) return;
  const uint first = push.halfEdges + 2u * cornersBefore[i];
  parents[push.faces + i] = order[i];
  offsets[push.faces + i] = first;
  place[order[i]] = first;
  // A vertex without half-edges is among the first: then nothing ends where it should, and is reported.
  if (i + 1u == push.count) offsets[push.faces + push.count] = valence[0] == 0u ? 0u : first + 2u * valence[i];
}
