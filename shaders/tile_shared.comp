#version 450
#extension GL_GOOGLE_include_directive : require
// Tiles whose points are kept in the workgroup's shared memory.
#include "evaluate.glsl"

layout(constant_id = 9) const uint kScratchPoints = 1u;  // room for the largest tile

shared vec4 scratch[kScratchPoints];

vec4 ownPoint(uint i) { return scratch[i]; }
void keepPoint(uint i, vec4 p) { scratch[i] = kLength > 3u ? p : vec4(p.xyz, 0.0); }
uint pairOf(uint i) { return i / 2u; }
void keepPair(uint pair, vec4 p, vec4 q) {
  keepPoint(2u * pair, p);
  keepPoint(2u * pair + 1u, q);
}
void findSlice() {}
void settle() { barrier(); }

const bool kDealt = false;
void askForTile() {}
uint givenTile() { return 0u; }

#include "tile.glsl"
