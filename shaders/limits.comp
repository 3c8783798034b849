#version 450
#extension GL_GOOGLE_include_directive : require
// FrameBatch: one invocation an element; its limit position, and its unit normal A x B. kLength is 3.
#include "evaluate.glsl"
#include "source.glsl"
#include "unit.glsl"

layout(set = 0, binding = 1) restrict readonly buffer Indices { uint indices[]; };
layout(set = 0, binding = 2) restrict readonly buffer Weights { float weights[]; };
layout(set = 0, binding = 3) restrict writeonly buffer Positions { float positions[]; };
layout(set = 0, binding = 4) restrict writeonly buffer Normals { float normals[]; };
layout(set = 0, binding = 5) restrict readonly buffer Elements { uint elements[]; };

// Up to 16 sides are a constant. Their loops are unrolled, and their weights are read once, before invocations part.
const bool kUnrolled = kSides != 0u;
const uint kKnownWeights = 3u * kSides + 1u;
float known[kKnownWeights];

uint sides() { return kUnrolled ? kSides : push.sides; }

void readWeights() {
  if (!kUnrolled) return;
  for (uint k = 0u; k < 3u * kSides; ++k) known[k] = weights[push.firstWeight + k];
}

float weight(uint k) {
  if (kUnrolled) return known[k];
  return weights[push.firstWeight + k];
}

vec3 sourcePoint(uint index) {
  const uint point = indices[index];
  return vec3(sourceValue(point, 0u), sourceValue(point, 1u), sourceValue(point, 2u));
}

// The weighted sums of the block's points that begins with corner `first`, in ascending order.
void addBlock(uint index, uint first, inout precise vec3 position, inout precise vec3 tangent1,
              inout precise vec3 tangent2) {
  const uint end = min(first + kProjectionBlock, sides());
  const uint a = sides();
  const uint b = 2u * sides();
  vec3 p = sourcePoint(index + first);
  precise vec3 sumM = weight(first) * p;
  precise vec3 sumA = weight(a + first) * p;
  precise vec3 sumB = weight(b + first) * p;
  for (uint j = first + 1u; j < end; ++j) {
    p = sourcePoint(index + j);
    precise vec3 termM = weight(j) * p;
    precise vec3 termA = weight(a + j) * p;
    precise vec3 termB = weight(b + j) * p;
    sumM = sumM + termM;
    sumA = sumA + termA;
    sumB = sumB + termB;
  }
  if (first == 0u) {
    position = sumM;
    tangent1 = sumA;
    tangent2 = sumB;
  } else {
    position = position + sumM;
    tangent1 = tangent1 + sumA;
    tangent2 = tangent2 + sumB;
  }
}

// A result that isn't wanted has a stride of 0, or a window of no numbers.
void writePosition(uint element, vec3 p) {
  const uint n = push.targetOffset + element * kTargetStride - push.windowBegin;
  if (kTargetStride == 0u) return;
  if (!kWindowed || n < push.windowSize) positions[n] = p.x;
  if (!kWindowed || n + 1u < push.windowSize) positions[n + 1u] = p.y;
  if (!kWindowed || n + 2u < push.windowSize) positions[n + 2u] = p.z;
}

void writeNormal(uint element, vec3 v) {
  const uint n = push.normalOffset + element * kNormalStride - push.normalBegin;
  if (kNormalStride == 0u) return;
  if (!kWindowed || n < push.normalSize) normals[n] = v.x;
  if (!kWindowed || n + 1u < push.normalSize) normals[n + 1u] = v.y;
  if (!kWindowed || n + 2u < push.normalSize) normals[n + 2u] = v.z;
}

void main() {
  readWeights();
  const uint g = invocation();
  if (g >= push.count) return;
  const uint index = push.firstIndex + g * sides();
  precise vec3 position = vec3(0.0), tangent1 = vec3(0.0), tangent2 = vec3(0.0);
  for (uint first = 0u; first < sides(); first += kProjectionBlock) addBlock(index, first, position, tangent1, tangent2);
  const uint element = elements[push.firstRecord + g];
  writePosition(element, position);
  writeNormal(element, unitNormal(tangent1, tangent2));
}
