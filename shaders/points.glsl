#include "push.glsl"

// The evaluator's buffers, read where they lie: point i's value j is data[offset + i * stride + j].

layout(set = 1, binding = 0, std430) restrict readonly buffer Positions { float positions[]; };
layout(set = 1, binding = 1, std430) restrict readonly buffer Normals { float normals[]; };
layout(set = 1, binding = 2, std430) restrict readonly buffer FaceOffsets { int faceOffsets[]; };
layout(set = 1, binding = 3, std430) restrict readonly buffer Corners { int corners[]; };
layout(set = 1, binding = 4, std430) restrict readonly buffer FaceColours { uint faceColours[]; };

vec3 positionOf(uint v) {
  const uint i = positionOffset + v * positionStride;
  return vec3(positions[i], positions[i + 1], positions[i + 2]);
}

vec3 normalOf(uint v) {
  const uint i = normalOffset + v * normalStride;
  return vec3(normals[i], normals[i + 1], normals[i + 2]);
}
