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
