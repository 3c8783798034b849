#version 450
#extension GL_GOOGLE_include_directive : require
#include "push.glsl"

layout(location = 0) in float across;  // pixels from the line's middle
layout(location = 0) out vec4 colour;

void main() {
  const float cover = 1 - smoothstep(halfWidth - 0.5, halfWidth + 0.7, abs(across));
  colour = vec4(lineColour.rgb, lineColour.a * cover);
}
