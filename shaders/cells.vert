#version 450
#extension GL_GOOGLE_include_directive : require
#include "points.glsl"
#include "scene.glsl"

layout(location = 0) out vec3 worldPosition;
layout(location = 1) out vec3 worldNormal;
layout(location = 2) out float inside;           // 0 on the cell's boundary, 1 at its centre
layout(location = 3) flat out uint cellColour;   // these two come from the triangle's first vertex, the centre
layout(location = 4) flat out vec3 facetNormal;

void corner(uint v) {
  worldPosition = positionOf(v);
  worldNormal = normalOf(v);
  inside = 0;
}

// How far from flat a cell is, 0..1: white, yellow, red, black.
vec3 heat(float t) {
  const vec3 stops[4] = vec3[](vec3(0.93, 0.94, 0.92), vec3(0.95, 0.76, 0.30), vec3(0.78, 0.16, 0.22), vec3(0.10, 0.03, 0.10));
  const float s = 3 * clamp(t, 0, 1);
  const int i = min(int(s), 2);
  return mix(stops[i], stops[i + 1], s - float(i));
}

// Viewer::flatness is the same on the CPU.
float bend(int begin, int end, vec3 middle, vec3 normal) {
  float away = 0;
  float radius = 0;
  for (int h = begin; h < end; ++h) {
    const vec3 arm = positionOf(corners[h]) - middle;
    away = max(away, abs(dot(arm, normal)));
    radius = max(radius, dot(arm, arm));
  }
  return away / max(2 * sqrt(radius), 1e-30);
}

// The centroid, the mean of the corners' normals and Newell's normal.
void centre(uint f) {
  const int begin = faceOffsets[f];
  const int end = faceOffsets[f + 1];
  const vec3 origin = positionOf(corners[begin]);
  vec3 sum = vec3(0);
  vec3 normalSum = vec3(0);
  vec3 area = vec3(0);
  vec3 last = positionOf(corners[end - 1]) - origin;
  for (int h = begin; h < end; ++h) {
    const vec3 here = positionOf(corners[h]) - origin;
    sum += here;
    normalSum += normalOf(corners[h]);
    area += cross(last, here);
    last = here;
  }
  worldPosition = origin + sum / float(end - begin);
  worldNormal = normalSum / float(end - begin);
  inside = 1;
  cellColour = faceColours[f];
  facetNormal = area;
  if (scene.picture.z > 0) {
    const float t = bend(begin, end, worldPosition, area / max(length(area), 1e-30)) / scene.picture.w;
    cellColour = packUnorm4x8(vec4(heat(sqrt(t)), 1));
  }
}

void main() {
  cellColour = 0;
  facetNormal = vec3(0);
  const uint i = gl_VertexIndex;
  if (i < vertexCount) {
    corner(i);
  } else {
    centre(i - vertexCount);
  }
  gl_Position = scene.viewProjection * vec4(worldPosition, 1);
}
