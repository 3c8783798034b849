// Tiles whose points are kept in a slice of a buffer, one for each workgroup: written as a storage buffer, read as
// texels. On lavapipe reads of a storage buffer go lane by lane, those of texels don't; texel fetches may not see what
// the same dispatch wrote, image loads may.
#include "evaluate.glsl"

layout(constant_id = 17) const bool kOneSubgroup = false;  // a workgroup is one subgroup
layout(constant_id = 18) const bool kDealt = false;        // workgroups ask for tiles

layout(set = 0, binding = 3, std430) coherent writeonly buffer Scratch { vec4 scratch[]; };
#ifdef LONG_STORES
layout(set = 0, binding = 3, std430) coherent writeonly buffer ScratchOfLongs { u64vec2 scratchOfLongs[]; };
layout(set = 0, binding = 3, std430) coherent writeonly buffer ScratchOfPairs { u64vec4 scratchOfPairs[]; };
#else
// As far apart as those of four numbers.
layout(set = 0, binding = 3, std430) coherent writeonly buffer ScratchOfThree { vec3 scratchOfThree[]; };
#endif
layout(set = 0, binding = 8, rgba32f) coherent readonly uniform imageBuffer scratchTexels;

// The first number of the buffer: tiles that were asked for. 0 when the dispatch begins.
layout(set = 0, binding = 3, std430) coherent buffer Dealer { uint dealt; };

// Where the workgroup's slice begins: an even texel. Found once: lavapipe reads a push constant lane by lane.
uint slice;
void findSlice() { slice = 2u + gl_WorkGroupID.x * push.firstOutput; }

// One invocation asks; all read the answer behind the next settle(), at the end of their slice.
uint answer() { return slice + push.firstOutput - 1u; }
void askForTile() {
  if (gl_LocalInvocationID.x != 0u) return;
  scratch[answer()] = uintBitsToFloat(uvec4(gl_NumWorkGroups.x + atomicAdd(dealt, 1u), 0u, 0u, 0u));
}
uint givenTile() { return floatBitsToUint(imageLoad(scratchTexels, int(answer())).x); }

// A fourth number that nobody wrote is not computed with: it may be denormal, which costs a CPU a hundred cycles.
vec4 ownPoint(uint i) {
  const vec4 p = imageLoad(scratchTexels, int(slice + i));
  return kLength > 3u ? p : vec4(p.xyz, 0.0);
}

#ifdef LONG_STORES
u64vec2 longsOf(vec4 p) { return u64vec2(longOf(p.xy), longOf(kLength > 3u ? p.zw : vec2(p.z, 0.0))); }
#endif

void keepTexel(uint texel, vec4 p) {
#ifdef LONG_STORES
  scratchOfLongs[texel] = longsOf(p);
#else
  if (kLength > 3u) {
    scratch[texel] = p;
  } else {
    scratchOfThree[texel] = p.xyz;
  }
#endif
}
void keepPoint(uint i, vec4 p) { keepTexel(slice + i, p); }

// Points i, which is even, and i + 1 are pair pairOf(i).
uint pairOf(uint i) { return (slice + i) / 2u; }
void keepPair(uint pair, vec4 p, vec4 q) {
#ifdef LONG_STORES
  scratchOfPairs[pair] = u64vec4(longsOf(p), longsOf(q));
#else
  keepTexel(2u * pair, p);
  keepTexel(2u * pair + 1u, q);
#endif
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
