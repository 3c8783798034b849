#version 450
#extension GL_GOOGLE_include_directive : require
#include "points.glsl"
#include "scene.glsl"

// Depth of the mesh as one of the lights sees it; the viewport is the light's tile.
void main() {
  const vec4 q = scene.lights[light].toTile * vec4(positionOf(gl_VertexIndex), 1);
  gl_Position = vec4(2 * q.xy - 1, q.z, 1);
}
