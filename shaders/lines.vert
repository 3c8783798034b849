#version 450
#extension GL_GOOGLE_include_directive : require
#include "points.glsl"
#include "scene.glsl"

layout(location = 0) out float across;  // pixels from the line's middle

// A line as a ribbon of constant width on the screen, six vertices each, drawn a little before the surface it lies on.
const vec2 kRibbon[6] = vec2[](vec2(0, -1), vec2(1, -1), vec2(1, 1), vec2(0, -1), vec2(1, 1), vec2(0, 1));
const float kPadding = 0.7;  // pixels beside the line over which it fades
const float kForward = 0.0012;

void ends(uint line, out vec3 a, out vec3 b) {
  if (spikes != 0) {
    a = positionOf(line);
    b = a + reach * normalOf(line);
  } else {
    a = positionOf(corners[2 * line]);
    b = positionOf(corners[2 * line + 1]);
  }
}

void main() {
  vec3 a, b;
  ends(gl_VertexIndex / 6, a, b);
  const vec2 place = kRibbon[gl_VertexIndex % 6];
  const vec4 p = scene.viewProjection * vec4(mix(a, b, place.x), 1);
  const vec4 q = scene.viewProjection * vec4(mix(b, a, place.x), 1);
  // Directions in pixels; ends behind the eye are clipped away with their whole line.
  vec2 along = (q.xy / q.w - p.xy / p.w) * scene.picture.xy * (place.x > 0.5 ? -1 : 1);
  along = length(along) > 1e-6 ? normalize(along) : vec2(1, 0);
  const float width = halfWidth + kPadding;
  const vec2 aside = place.y * width * vec2(-along.y, along.x) * 2 / scene.picture.xy;
  across = place.y * width;
  gl_Position = p + vec4(aside * p.w, -kForward * p.w * (1 - p.z / p.w), 0);
  if (p.w <= 0 || q.w <= 0) gl_Position = vec4(2, 2, 2, 1);
}
