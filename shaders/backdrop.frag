#version 450
#extension GL_GOOGLE_include_directive : require
#include "scene.glsl"

layout(location = 0) in vec2 ndc;
layout(location = 0) out vec4 colour;

// The share of the ground's light that arrives at p, 0..1.
float groundLight(vec3 p) {
  mat2 turn = turnBy(6.2831853 * noise(gl_FragCoord.xy));
  const mat2 onward = turnBy(2.4);
  float sum = 0;
  for (int k = shadowCount(); k < lightCount(); ++k) sum += scene.lights[k].radiance.w;
  for (int k = 0; k < shadowCount(); ++k) {
    turn = onward * turn;
    sum += scene.lights[k].radiance.w * reached(k, p, turn);
  }
  return sum;
}

// A seamless studio: a soft gradient that takes the shadow of what stands on the ground.
void main() {
  const float far = dot(ndc * vec2(0.55, 0.6) + vec2(0, 0.08), ndc * vec2(0.55, 0.6) + vec2(0, 0.08));
  vec3 wall = mix(scene.backdropCentre.rgb, scene.backdropRim.rgb, smoothstep(0.0, 0.75, far));
  const vec4 ahead = scene.inverseViewProjection * vec4(ndc, 1, 1);
  const vec3 ray = ahead.xyz / ahead.w - scene.eye.xyz;
  const float t = (scene.ground.y - scene.eye.y) / ray.y;
  if (scene.shadowTint.w > 0 && ray.y < 0 && t > 0) {
    const vec3 p = scene.eye.xyz + t * ray;
    const float away = length(p - scene.ground.xyz) / scene.ground.w;
    if (away < 1) {
      const float shade = (1 - groundLight(p)) * (1 - smoothstep(0.6, 1.0, away));
      wall *= mix(vec3(1), scene.shadowTint.rgb, shade);
    }
  }
  // Half a step of 8-bit noise keeps the gradient from banding.
  wall += (noise(gl_FragCoord.xy + 17) - 0.5) * (0.006 * sqrt(wall));
  colour = vec4(wall, 1);
}
