// What all of the renderer's shaders share. The block's layout is Viewer::SceneBlock's.

const int kLights = 16;
const int kTilesAcross = 4;

struct Light {
  mat4 toTile;    // world to a tile: x, y and depth in 0..1
  vec4 direction; // to the light, unit; w: blur of its shadow, in tiles
  vec4 radiance;  // linear rgb; w: its share of the light that falls on the ground
};

layout(set = 0, binding = 0, std140) uniform Scene {
  mat4 viewProjection;
  mat4 inverseViewProjection;
  vec4 eye;             // w: 1 when cells are faceted
  vec4 ground;          // xyz: the point of the ground below the middle; w: the reach of its shadow
  vec4 backdropCentre;  // linear rgb; w: edge half-width, pixels
  vec4 backdropRim;     // linear rgb; w: edge strength, 0..1
  vec4 shadowTint;      // linear rgb that a fully shadowed ground is multiplied by; w: 1 with a ground
  vec4 bounce;          // linear rgb from below; w: width of the normal offset of shadow look-ups, world units
  vec4 rimDirection;    // to the light behind, unit; w: how many of the lights there are
  vec4 rimRadiance;     // linear rgb; w: how many of the lights throw shadows
  vec4 keyDirection;    // unit; w: specular exponent
  vec4 keyRadiance;     // linear rgb; w: specular strength
  vec4 picture;         // width, height in pixels; z: 1: cells are coloured by how far from flat they are; w: what is the most
  Light lights[kLights];
}
scene;

layout(set = 0, binding = 1) uniform sampler2DShadow shadows;

// Not a constant, so that drivers don't unroll the loops over lights: they compile in a third of the time.
int lightCount() { return int(scene.rimDirection.w); }
// The first ones throw shadows.
int shadowCount() { return int(scene.rimRadiance.w); }

// How much of light k reaches p, 0..1: three taps, turned by `turn` so that neighbouring pixels and lights sample
// different places.
float reached(int k, vec3 p, mat2 turn) {
  const vec3 q = (scene.lights[k].toTile * vec4(p, 1)).xyz;
  const float blur = scene.lights[k].direction.w;
  if (any(lessThan(q, vec3(blur))) || any(greaterThan(q, vec3(1 - blur)))) return 1;
  const vec2 tile = vec2(k % kTilesAcross, k / kTilesAcross);
  const vec2 taps[3] = vec2[](vec2(0, 0.5), vec2(0.69, -0.4), vec2(-0.78, -0.45));
  float sum = 0;
  for (int i = 0; i < 3; ++i) {
    sum += texture(shadows, vec3((tile + q.xy + blur * (turn * taps[i])) / kTilesAcross, q.z));
  }
  return sum / 3;
}

// Interleaved gradient noise (Jimenez 2014): 0..1, even over every small block of pixels.
float noise(vec2 pixel) { return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))); }

mat2 turnBy(float angle) { return mat2(cos(angle), sin(angle), -sin(angle), cos(angle)); }

// Light above 0.7 bends into white instead of clipping.
vec3 shoulder(vec3 c) {
  const vec3 bent = 0.7 + 0.3 * (1 - exp((0.7 - c) / 0.3));
  return mix(c, bent, greaterThan(c, vec3(0.7)));
}
