#version 450
#extension GL_GOOGLE_include_directive : require
// Tiles whose points are kept in a slice of a buffer, one for each workgroup: written as a storage buffer, read as
// texels. On lavapipe reads of a storage buffer go lane by lane, those of texels don't; texel fetches may not see what
// the same dispatch wrote, image loads may.
#include "evaluate.glsl"

layout(set = 0, binding = 3, std430) coherent writeonly buffer Scratch { vec4 scratch[]; };
// As far apart as those of four numbers.
layout(set = 0, binding = 3, std430) coherent writeonly buffer ScratchOfThree { vec3 scratchOfThree[]; };
layout(set = 0, binding = 8, rgba32f) coherent readonly uniform imageBuffer scratchTexels;

uint slice() { return gl_WorkGroupID.x * push.firstOutput; }

// A fourth number that nobody wrote is not computed with: it may be denormal, which costs a CPU a hundred cycles.
vec4 ownPoint(uint i) {
  const vec4 p = imageLoad(scratchTexels, int(slice() + i));
  return kLength > 3u ? p : vec4(p.xyz, 0.0);
}

void keepPoint(uint i, vec4 p) {
  if (kLength > 3u) {
    scratch[slice() + i] = p;
  } else {
    scratchOfThree[slice() + i] = p.xyz;
  }
}

void settle() {
  groupMemoryBarrier();
  barrier();
}

#include "tile.glsl"
