#version 450
#extension GL_GOOGLE_include_directive : require
// ProjectedFace, second step: one invocation a face, component and projection adds the blocks in ascending order.
#include "evaluate.glsl"
#include "projected.glsl"

layout(set = 0, binding = 3) restrict writeonly buffer Sums { float sums[]; };
layout(set = 0, binding = 4) restrict readonly buffer Blocks { float blocks[]; };

void main() {
  const uint id = invocation();
  const uint perFace = 3u * kLength;
  if (id >= push.count * perFace) return;
  const ProjectedFace face = faces[push.firstRecord + id / perFace];
  const uint first = face.firstBlock * perFace + id % perFace;
  precise float sum = blocks[first];
  for (uint b = 1u; b < face.blockCount; ++b) sum = sum + blocks[first + b * perFace];
  sums[id] = sum;
}
