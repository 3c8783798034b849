// The points that are read.
#define NUMBER float
#include "pages.glsl"

float sourceValue(uint point, uint c) { return sourceNumber(push.sourceOffset + point * kSourceStride + c); }
