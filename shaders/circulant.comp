#version 450
#extension GL_GOOGLE_include_directive : require
// CirculantBatch: one invocation a face, kSides corners in, kSides points out.
#include "evaluate.glsl"
#include "source.glsl"
#include "target.glsl"

layout(set = 0, binding = 1) restrict readonly buffer Indices { uint indices[]; };
layout(set = 0, binding = 2) restrict readonly buffer Weights { float weights[]; };

const bool kUnrolled = kSides <= 16u;

// Loops over up to 16 sides have constant bounds and are unrolled, longer ones are not.
uint sides() { return kUnrolled ? kSides : push.sides; }

float weight(uint k) {
  if (kUnrolled) return push.weights[k & 15u];
  return weights[push.firstWeight + k];
}

#define VALUE float
#define BEFORE p
#define AFTER next
#define MOST kSides
#define SIDES sides()
#define WEIGHT(k) weight(k)
void evolveDirect(inout float p[kSides], out float next[kSides]) {
#define SHAPE SHAPE_DIRECT
#include "circulant_form.glsl"
#undef SHAPE
}

void evolveEvenOdd(inout float p[kSides], out float next[kSides]) {
#define SHAPE SHAPE_EVEN_ODD
#include "circulant_form.glsl"
#undef SHAPE
}

void evolveQuad(inout float p[kSides], out float next[kSides]) {
#define SHAPE SHAPE_QUAD
#include "circulant_form.glsl"
#undef SHAPE
}

void evolveHexagon(inout float p[kSides], out float next[kSides]) {
#define SHAPE SHAPE_HEXAGON
#include "circulant_form.glsl"
#undef SHAPE
}

void main() {
  const uint face = invocation();
  if (face >= push.count) return;
  uint corner[kSides];
  for (uint i = 0u; i < sides(); ++i) corner[i] = indices[push.firstIndex + face * kSides + i];
  const uint firstOutput = push.firstOutput + face * kSides;
  for (uint c = 0u; c < kLength; ++c) {
    float p[kSides];
    float next[kSides];
    for (uint i = 0u; i < sides(); ++i) p[i] = sourceValue(corner[i], c);
    if (kForm == SHAPE_DIRECT) {
      evolveDirect(p, next);
    } else if (kForm == SHAPE_EVEN_ODD) {
      evolveEvenOdd(p, next);
    } else if (kForm == SHAPE_QUAD) {
      evolveQuad(p, next);
    } else {
      evolveHexagon(p, next);
    }
    for (uint i = 0u; i < sides(); ++i) writeTarget(firstOutput + i, c, next[i]);
  }
}
