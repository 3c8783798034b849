#version 450
#extension GL_GOOGLE_include_directive : require
// CirculantBatch: one invocation a face, kSides corners in, kSides points out.
#include "evaluate.glsl"
#include "source.glsl"
#include "target.glsl"

layout(set = 0, binding = 1) restrict readonly buffer Indices { uint indices[]; };
layout(set = 0, binding = 2) restrict readonly buffer Weights { float weights[]; };

const uint kHalf = kSides / 2u;
const bool kUnrolled = kSides <= 16u;

// Loops over up to 16 sides have constant bounds and are unrolled, longer ones are not.
uint sides() { return kUnrolled ? kSides : push.sides; }
uint halfSides() { return kUnrolled ? kHalf : push.sides / 2u; }

float weight(uint k) {
  if (kUnrolled) return push.weights[k & 15u];
  return weights[push.firstWeight + k];
}

// out_i = ((c_0 p_i + c_1 p_{i+1}) + c_2 p_{i+2}) + ...
void evaluateDirect(uint firstOutput, uint c, uint corner[kSides]) {
  float p[kSides];
  for (uint i = 0u; i < sides(); ++i) p[i] = sourceValue(corner[i], c);
  for (uint i = 0u; i < sides(); ++i) {
    precise float sum = weight(0u) * p[i];
    for (uint k = 1u; k < sides(); ++k) {
      const uint j = i + k < kSides ? i + k : i + k - kSides;
      precise float term = weight(k) * p[j];
      sum = sum + term;
    }
    writeTarget(firstOutput + i, c, sum);
  }
}

// Sums and differences of opposite corners: half the multiplications.
void evaluateEvenOdd(uint firstOutput, uint c, uint corner[kSides]) {
  precise float q[kHalf];
  precise float d[kHalf];
  for (uint j = 0u; j < halfSides(); ++j) {
    const float here = sourceValue(corner[j], c);
    const float opposite = sourceValue(corner[j + kHalf], c);
    q[j] = here + opposite;
    d[j] = here - opposite;
  }
  for (uint i = 0u; i < halfSides(); ++i) {
    precise float e = weight(0u) * q[i];
    precise float o = weight(kHalf) * d[i];
    for (uint k = 1u; k < halfSides(); ++k) {
      const bool wraps = i + k >= kHalf;
      const uint j = wraps ? i + k - kHalf : i + k;
      precise float evenTerm = weight(k) * q[j];
      precise float oddTerm = weight(kHalf + k) * d[j];
      e = e + evenTerm;
      if (wraps) {
        o = o - oddTerm;
      } else {
        o = o + oddTerm;
      }
    }
    precise float upper = e + o;
    precise float lower = e - o;
    writeTarget(firstOutput + i, c, upper);
    writeTarget(firstOutput + i + kHalf, c, lower);
  }
}

// The sum and the differences of opposite corners of a row that is its own mirror image about an edge.
void evaluateQuad(uint firstOutput, uint c, uint corner[kSides]) {
  precise float q[2];
  precise float d[2];
  for (uint j = 0u; j < 2u; ++j) {
    const float here = sourceValue(corner[j % kSides], c);
    const float opposite = sourceValue(corner[(j + 2u) % kSides], c);
    q[j] = here + opposite;
    d[j] = here - opposite;
  }
  precise float s = weight(0u) * (q[0] + q[1]);
  precise float o[2] = float[2](weight(1u) * (d[0] + d[1]), weight(1u) * (d[1] - d[0]));
  for (uint i = 0u; i < 2u; ++i) {
    precise float upper = s + o[i];
    precise float lower = s - o[i];
    writeTarget(firstOutput + i, c, upper);
    writeTarget(firstOutput + i + 2u, c, lower);
  }
}

void evaluateHexagon(uint firstOutput, uint c, uint corner[kSides]) {
  precise float q[3];
  precise float d[3];
  for (uint j = 0u; j < 3u; ++j) {
    const float here = sourceValue(corner[j % kSides], c);
    const float opposite = sourceValue(corner[(j + 3u) % kSides], c);
    q[j] = here + opposite;
    d[j] = here - opposite;
  }
  precise float s = weight(0u) * ((q[0] + q[1]) + q[2]);
  precise float o[3] =
      float[3](weight(2u) * (d[0] + d[1]), weight(2u) * (d[1] + d[2]), weight(2u) * (d[2] - d[0]));
  for (uint i = 0u; i < 3u; ++i) {
    precise float e = s - weight(1u) * q[(i + 2u) % 3u];
    precise float upper = e + o[i];
    precise float lower = e - o[i];
    writeTarget(firstOutput + i, c, upper);
    writeTarget(firstOutput + i + 3u, c, lower);
  }
}

void main() {
  const uint face = invocation();
  if (face >= push.count) return;
  uint corner[kSides];
  for (uint i = 0u; i < sides(); ++i) corner[i] = indices[push.firstIndex + face * kSides + i];
  const uint firstOutput = push.firstOutput + face * kSides;
  for (uint c = 0u; c < kLength; ++c) {
    if (kForm == kDirect) {
      evaluateDirect(firstOutput, c, corner);
    } else if (kForm == kEvenOdd) {
      evaluateEvenOdd(firstOutput, c, corner);
    } else if (kForm == kQuad) {
      evaluateQuad(firstOutput, c, corner);
    } else {
      evaluateHexagon(firstOutput, c, corner);
    }
  }
}
