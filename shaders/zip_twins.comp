#version 450
#extension GL_GOOGLE_include_directive : require
// The twins of the half-edges of a level made by zip, one invocation each: of those A, B and C that
// far/topology/splits/zip_closed.cpp makes of a half-edge h, C(next h), B(twin h) and A(prev h).
#include "connectivity.glsl"
#define NUMBER uint
#include "pages.glsl"
#include "zip_level.glsl"

layout(set = 0, binding = 3) restrict writeonly buffer Target { uint target[]; };

// vert of the level itself: the pages from push.value on, or page 1 where each level is one page.
uint vertexOf(uint h) {
  const uint n = min(h, 3u * push.parents - 1u);
  if (kPageShift == 0u) return source[1].values[n];
  return sourceNumber((push.value << kPageShift) + n);
}

uint twinOf(uint h) {
  if (h < push.parents) return cornerOf(nextOf(h));
  if ((h - push.parents) % 2u == 0u) return prevOf(vertexOf(h));
  // Behind B(h) stands C of the half-edge that leaves the same vertex as twin h does: twin h itself.
  return cornerOf(nextOf(vertexOf(nextOf(h)))) + 1u;
}

void main() {
  const uint i = invocation();
  if (i >= push.count) return;
  target[push.first + i - push.windowBegin] = twinOf(push.first + i);
}
