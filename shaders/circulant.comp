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
void evaluateOdd(uint firstOutput, uint c, uint corner[kSides]) {
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
void evaluateEven(uint firstOutput, uint c, uint corner[kSides]) {
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

void main() {
  const uint face = invocation();
  if (face >= push.count) return;
  uint corner[kSides];
  for (uint i = 0u; i < sides(); ++i) corner[i] = indices[push.firstIndex + face * kSides + i];
  const uint firstOutput = push.firstOutput + face * kSides;
  for (uint c = 0u; c < kLength; ++c) {
    if ((kSides & 1u) == 1u) {
      evaluateOdd(firstOutput, c, corner);
    } else {
      evaluateEven(firstOutput, c, corner);
    }
  }
}
