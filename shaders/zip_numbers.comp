#version 450
#extension GL_GOOGLE_include_directive : require
// Numbers that follow from where they stand: target number push.first + i is push.value + i * push.shift.
#include "connectivity.glsl"

layout(set = 0, binding = 3) restrict writeonly buffer Target { uint target[]; };

void main() {
  const uint i = invocation();
  if (i >= push.count) return;
  target[push.first + i - push.windowBegin] = push.value + i * push.shift;
}
