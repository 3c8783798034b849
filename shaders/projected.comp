#version 450
#extension GL_GOOGLE_include_directive : require
// ProjectedFace, last step: one invocation an output. A task is as many outputs of one face as a workgroup has
// invocations.
#include "evaluate.glsl"
#include "source.glsl"
#include "target.glsl"
#include "projected.glsl"

layout(set = 0, binding = 1) restrict readonly buffer Indices { uint indices[]; };
layout(set = 0, binding = 2) restrict readonly buffer Weights { float weights[]; };
layout(set = 0, binding = 4) restrict readonly buffer Sums { float sums[]; };
layout(set = 0, binding = 6) restrict readonly buffer Tasks { uvec2 tasks[]; };  // face, first output

void main() {
  const uint id = invocation();
  if (id >= push.count * gl_WorkGroupSize.x) return;
  const uvec2 task = tasks[push.firstTask + id / gl_WorkGroupSize.x];
  const ProjectedFace face = faces[push.firstRecord + task.x];
  const uint i = task.y + id % gl_WorkGroupSize.x;
  if (i >= face.outputs) return;
  uint a = face.firstCorner + i;
  if (a >= face.corners) a -= face.corners;
  const uint b = a + 1u < face.corners ? a + 1u : 0u;
  const uint pointA = indices[push.firstIndex + face.firstIndex + a];
  const uint pointB = indices[push.firstIndex + face.firstIndex + b];
  const uint w = push.firstWeight + face.firstWeight;
  const uint x = w + 2u + 3u * face.corners + i;
  const uint y = x + face.outputs;
  const uint z = y + face.outputs;
  for (uint c = 0u; c < kLength; ++c) {
    const uint sum = (task.x * kLength + c) * 3u;
    precise float here = weights[w] * sourceValue(pointA, c);
    precise float next = weights[w + 1u] * sourceValue(pointB, c);
    precise float mean = weights[x] * sums[sum];
    precise float cosine = weights[y] * sums[sum + 1u];
    precise float sine = weights[z] * sums[sum + 2u];
    precise float value = here + next;
    value = value + mean;
    value = value + cosine;
    value = value + sine;
    writeTarget(face.firstOutput + i, c, value);
  }
}
