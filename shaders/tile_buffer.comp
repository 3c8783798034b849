#version 450
#extension GL_GOOGLE_include_directive : require
// Tiles whose points are kept in a slice of a buffer, one for each workgroup: written as a storage buffer, read as texels. On lavapipe reads of
// a storage buffer go lane by lane, those of texels don't; texel fetches may not see what the same dispatch wrote, image
// loads may.
#include "evaluate.glsl"

layout(set = 0, binding = 3, std430) coherent writeonly buffer Scratch { vec4 scratch[]; };
layout(set = 0, binding = 8, rgba32f) coherent readonly uniform imageBuffer scratchTexels;

uint slice() { return gl_WorkGroupID.x * push.firstOutput; }
vec4 ownPoint(uint i) { return imageLoad(scratchTexels, int(slice() + i)); }
void keepPoint(uint i, vec4 p) { scratch[slice() + i] = kLength > 3u ? p : vec4(p.xyz, 0.0); }

void settle() {
  groupMemoryBarrier();
  barrier();
}

#include "tile.glsl"
