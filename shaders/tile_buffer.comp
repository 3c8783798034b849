#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
// Tiles whose points are kept in a slice of a buffer, one for each workgroup: written as a storage buffer, read as
// texels. On lavapipe reads of a storage buffer go lane by lane, those of texels don't; texel fetches may not see what
// the same dispatch wrote, image loads may.
#include "evaluate.glsl"

layout(constant_id = 17) const bool kOneSubgroup = false;  // a workgroup is one subgroup

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

// For a barrier of workgroups lavapipe keeps all variables, loop counters included, where they outlast a switch to other
// subgroups, even if there are none.
void settle() {
  if (kOneSubgroup) {
    subgroupBarrier();
  } else {
    groupMemoryBarrier();
    barrier();
  }
}

#include "tile.glsl"
