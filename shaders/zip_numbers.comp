#version 450
#extension GL_GOOGLE_include_directive : require
// Numbers that follow from where they stand: number n of the target is push.value + (n - push.parents) / push.most *
// push.shift, push.most 1 or 6, for those from push.first on.
#include "connectivity.glsl"

layout(set = 0, binding = 3) restrict writeonly buffer Target { uint target[]; };

void main() {
  const uint i = invocation();
  if (i >= push.count) return;
  const uint n = push.first + i;
  // Division by a constant is a multiplication.
  const uint from = n - push.parents;
  target[n - push.windowBegin] = push.value + (push.most == 6u ? from / 6u : from) * push.shift;
}
