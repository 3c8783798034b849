#version 450
#extension GL_GOOGLE_include_directive : require
// Far::NormalTable: one invocation a point, the direction of the sum of its faces' normals. The source is the normals.
#include "evaluate.glsl"
#include "source.glsl"
#include "target.glsl"
#include "unit.glsl"

layout(set = 0, binding = 1) restrict readonly buffer Faces { uint faces[]; };
layout(set = 0, binding = 6) restrict readonly buffer Offsets { uint offsets[]; };

vec3 faceNormal(uint entry) {
  const uint face = faces[push.firstIndex + entry];
  return vec3(sourceValue(face, 0u), sourceValue(face, 1u), sourceValue(face, 2u));
}

void main() {
  const uint row = invocation();
  if (row >= push.count) return;
  const uint begin = offsets[push.firstTask + row];
  const uint end = offsets[push.firstTask + row + 1u];
  precise vec3 sum = vec3(0.0);
  if (begin < end) sum = faceNormal(begin);
  for (uint b = begin + 1u; b < end; ++b) sum = sum + faceNormal(b);
  const vec3 normal = unit(sum);
  for (uint c = 0u; c < 3u; ++c) writeTarget(push.firstOutput + row, c, normal[c]);
}
