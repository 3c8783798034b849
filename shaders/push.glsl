// Viewer::PointPush.
layout(push_constant) uniform Push {
  uint vertexCount;
  uint positionOffset;
  uint positionStride;
  uint normalOffset;
  uint normalStride;
  uint light;
  uint spikes;      // of lines: 1: from each point along its normal; 0: between the points of each pair
  float reach;      // of lines: the length of a spike
  float halfWidth;  // of lines: pixels
  vec4 lineColour;  // of lines: linear rgb; w: opacity
};
