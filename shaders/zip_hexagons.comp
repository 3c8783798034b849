#version 450
#extension GL_GOOGLE_include_directive : require
// The loops of the hexagons that the vertices of a level made by zip become, one invocation a vertex: of the three
// half-edges that leave it, each and the one before it (far/topology/splits/zip_closed.cpp, ZippedFaces).
#include "connectivity.glsl"
#define NUMBER uint
#include "pages.glsl"
#include "zip_level.glsl"

layout(set = 0, binding = 3) restrict writeonly buffer Target { uint target[]; };

void write(uint n, uint value) {
  // Of the vertices at the window's ends, some numbers fall into others.
  const uint i = n - push.windowBegin;
  if (i < push.windowSize) target[i] = value;
}

void main() {
  const uint i = invocation();
  if (i >= push.count) return;
  const uint v = push.first + i;
  const uint here = cornerOf(v);
  const uint next = cornerOf(nextOf(v));
  const uint slot = 3u * push.parents + 6u * v;
  write(slot, v);
  write(slot + 1u, prevOf(v));
  write(slot + 2u, here);
  write(slot + 3u, prevOf(here));
  write(slot + 4u, next + 1u);
  write(slot + 5u, next);
}
