#version 450
#extension GL_GOOGLE_include_directive : require
// ProjectedFace, first step: one invocation a block of corners and component.
#include "evaluate.glsl"
#include "source.glsl"
#include "projected.glsl"

layout(set = 0, binding = 1) restrict readonly buffer Indices { uint indices[]; };
layout(set = 0, binding = 2) restrict readonly buffer Weights { float weights[]; };
layout(set = 0, binding = 3) restrict writeonly buffer Blocks { float blocks[]; };
layout(set = 0, binding = 6) restrict readonly buffer Tasks { uvec2 tasks[]; };  // face, first corner

void main() {
  const uint id = invocation();
  if (id >= push.count * kLength) return;
  const uint block = id / kLength;
  const uint c = id % kLength;
  const uvec2 task = tasks[push.firstTask + block];
  const ProjectedFace face = faces[push.firstRecord + task.x];
  const uint end = min(task.y + kProjectionBlock, face.corners);
  const uint index = push.firstIndex + face.firstIndex;
  const uint weightS = push.firstWeight + face.firstWeight + 2u;
  const uint weightC = weightS + face.corners;
  const uint weightD = weightC + face.corners;
  const bool sumOnly = face.outputs == 0u;
  const float first = sourceValue(indices[index + task.y], c);
  precise float s = weights[weightS + task.y] * first;
  precise float cosine = 0.0;
  precise float sine = 0.0;
  if (!sumOnly) {
    cosine = weights[weightC + task.y] * first;
    sine = weights[weightD + task.y] * first;
  }
  for (uint j = task.y + 1u; j < end; ++j) {
    const float p = sourceValue(indices[index + j], c);
    precise float termS = weights[weightS + j] * p;
    s = s + termS;
    if (sumOnly) continue;
    precise float termC = weights[weightC + j] * p;
    precise float termD = weights[weightD + j] * p;
    cosine = cosine + termC;
    sine = sine + termD;
  }
  blocks[3u * id] = s;
  blocks[3u * id + 1u] = cosine;
  blocks[3u * id + 2u] = sine;
}
