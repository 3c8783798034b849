// Unit vectors, by the operations of Far::LimitRows.
const float kSmallest = 1.17549435e-38;  // FLT_MIN
const float kLargest = 3.40282347e+38;   // FLT_MAX

// The zero vector where there is no direction.
vec3 unit(vec3 v) {
  precise float xx = v.x * v.x, yy = v.y * v.y, zz = v.z * v.z;
  precise float q = xx + yy;
  q = q + zz;
  if (!(q >= kSmallest && q <= kLargest)) return vec3(0.0);
  precise float root = sqrt(q);
  precise float r = 1.0 / root;
  precise vec3 direction = vec3(v.x * r, v.y * r, v.z * r);
  return direction;
}

// v + 0, which takes the sign from a zero: as an addition compilers leave it out.
vec3 plusZero(vec3 v) {
  const uvec3 bits = floatBitsToUint(v);
  return uintBitsToFloat(mix(bits, uvec3(0u), equal(bits << 1, uvec3(0u))));
}

// s x t made unit.
vec3 unitNormal(vec3 s, vec3 t) {
  precise float xa = s.y * t.z, xb = s.z * t.y;
  precise float ya = s.z * t.x, yb = s.x * t.z;
  precise float za = s.x * t.y, zb = s.y * t.x;
  precise vec3 normal = vec3(xa - xb, ya - yb, za - zb);
  return unit(plusZero(normal));
}
