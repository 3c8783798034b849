#version 450
#extension GL_GOOGLE_include_directive : require
#include "scene.glsl"

layout(location = 0) in vec3 worldPosition;
layout(location = 1) in vec3 worldNormal;
layout(location = 2) in float inside;
layout(location = 3) flat in uint cellColour;
layout(location = 4) flat in vec3 facetNormal;
layout(location = 0) out vec4 colour;

// How much of the pixel the edge's line covers. Edges of cells only a few pixels wide fade, lest they turn all to ink.
float edgeCover() {
  const float slope = max(length(vec2(dFdx(inside), dFdy(inside))), 1e-6);
  const float halfWidth = scene.backdropCentre.w;
  const float distance = abs(inside) / slope;
  const float apothem = 1 / slope;
  const float line = 1 - smoothstep(halfWidth - 0.6, halfWidth + 0.6, distance);
  return scene.backdropRim.w * line * smoothstep(1.2, 5.0, apothem);
}

// How much a surface faces light k. A gentle wrap: light reaches 12 degrees past the edge of shade, as it does round
// soft boxes.
float wrapped(vec3 n, int k) { return max((dot(n, scene.lights[k].direction.xyz) + 0.2) / 1.2, 0); }

vec3 diffuse(vec3 n, out float keyReached) {
  mat2 turn = turnBy(6.2831853 * noise(gl_FragCoord.xy));
  const mat2 onward = turnBy(2.4);
  const vec3 p = worldPosition + scene.bounce.w * n;
  vec3 sum = scene.bounce.rgb * (0.5 - 0.5 * n.y);
  float key = 0;
  float keys = 0;
  // Drivers that run both sides of every branch run a loop no longer than they must.
  for (int k = shadowCount(); k < lightCount(); ++k) sum += scene.lights[k].radiance.rgb * wrapped(n, k);
  for (int k = 0; k < shadowCount(); ++k) {
    turn = onward * turn;
    const Light l = scene.lights[k];
    const float facing = wrapped(n, k);
    if (facing <= 0) continue;
    const float part = reached(k, p, turn);
    sum += l.radiance.rgb * facing * part;
    const float isKey = step(0.99, dot(l.direction.xyz, scene.keyDirection.xyz));
    key += isKey * part;
    keys += isKey;
  }
  keyReached = keys > 0 ? key / keys : 0;
  return sum;
}

void main() {
  const vec3 toEye = normalize(scene.eye.xyz - worldPosition);
  vec3 n = normalize(mix(normalize(worldNormal + 1e-9), normalize(facetNormal + 1e-9), scene.eye.w));
  if (!gl_FrontFacing) n = -n;
  float keyReached;
  const vec3 light = diffuse(n, keyReached);
  const vec4 srgb = unpackUnorm4x8(cellColour);
  const vec3 base = mix(srgb.rgb / 12.92, pow((srgb.rgb + 0.055) / 1.055, vec3(2.4)), greaterThan(srgb.rgb, vec3(0.04045)));
  const vec3 albedo = mix(base, base * base * 0.25 + 0.01 * base, edgeCover());

  const vec3 halfway = normalize(scene.keyDirection.xyz + toEye);
  const float shine = scene.keyRadiance.w * pow(max(dot(n, halfway), 0), scene.keyDirection.w) * keyReached;
  const float grazing = pow(1 - clamp(dot(n, toEye), 0, 1), 4);
  const vec3 rim = scene.rimRadiance.rgb * grazing * clamp(dot(n, scene.rimDirection.xyz) + 0.3, 0, 1);
  colour = vec4(shoulder(albedo * light + scene.keyRadiance.rgb * shine + rim * (0.25 + albedo)), 1);
}
