// The body of a function that brings the corners of a face to the next level by one form of a circulant
// (Far::CirculantForm). The order of operations is that of far/tables/level_table.h. Who includes it has defined
//     SHAPE      the form
//     VALUE      float or vec4: a number of each corner, or all of them
//     BEFORE     the array of the corners, which may be changed
//     AFTER      that of the results
//     MOST       their length, a constant
//     SIDES      how many of them there are; a constant where loops are to be unrolled
//     WEIGHT(k)  number k of the form
#if SHAPE == SHAPE_QUAD
  // Where a face has other sides this is compiled and never runs: no index passes the array's end.
  precise VALUE q0 = BEFORE[0] + BEFORE[2u % MOST], q1 = BEFORE[1u % MOST] + BEFORE[3u % MOST];
  precise VALUE d0 = BEFORE[0] - BEFORE[2u % MOST], d1 = BEFORE[1u % MOST] - BEFORE[3u % MOST];
  precise VALUE s = WEIGHT(0u) * (q0 + q1);
  precise VALUE o0 = WEIGHT(1u) * (d0 + d1);
  precise VALUE o1 = WEIGHT(1u) * (d1 - d0);
  precise VALUE upper0 = s + o0, upper1 = s + o1;
  precise VALUE lower0 = s - o0, lower1 = s - o1;
  AFTER[0] = upper0;
  AFTER[1u % MOST] = upper1;
  AFTER[2u % MOST] = lower0;
  AFTER[3u % MOST] = lower1;
#elif SHAPE == SHAPE_HEXAGON
  precise VALUE q[3];
  precise VALUE d[3];
  for (uint j = 0u; j < 3u; ++j) {
    q[j] = BEFORE[j % MOST] + BEFORE[(j + 3u) % MOST];
    d[j] = BEFORE[j % MOST] - BEFORE[(j + 3u) % MOST];
  }
  precise VALUE s = WEIGHT(0u) * ((q[0] + q[1]) + q[2]);
  precise VALUE o[3] = VALUE[3](WEIGHT(2u) * (d[0] + d[1]), WEIGHT(2u) * (d[1] + d[2]), WEIGHT(2u) * (d[2] - d[0]));
  for (uint i = 0u; i < 3u; ++i) {
    precise VALUE e = s - WEIGHT(1u) * q[(i + 2u) % 3u];
    precise VALUE upper = e + o[i];
    precise VALUE lower = e - o[i];
    AFTER[i % MOST] = upper;
    AFTER[(i + 3u) % MOST] = lower;
  }
#elif SHAPE == SHAPE_EVEN_ODD
  // Half the multiplications: first the sums of opposite corners take the place of one, their differences that of the
  // other.
  const uint m = SIDES / 2u;
  for (uint j = 0u; j < m; ++j) {
    precise VALUE q = BEFORE[j] + BEFORE[j + m];
    precise VALUE d = BEFORE[j] - BEFORE[j + m];
    BEFORE[j] = q;
    BEFORE[j + m] = d;
  }
  for (uint i = 0u; i < m; ++i) {
    precise VALUE e = WEIGHT(0u) * BEFORE[i];
    precise VALUE o = WEIGHT(m) * BEFORE[i + m];
    for (uint k = 1u; k < m; ++k) {
      const bool wraps = i + k >= m;
      const uint j = wraps ? i + k - m : i + k;
      precise VALUE even = WEIGHT(k) * BEFORE[j];
      precise VALUE odd = WEIGHT(m + k) * BEFORE[j + m];
      e = e + even;
      if (wraps) {
        o = o - odd;
      } else {
        o = o + odd;
      }
    }
    precise VALUE upper = e + o;
    precise VALUE lower = e - o;
    AFTER[i] = upper;
    AFTER[i + m] = lower;
  }
#else
  for (uint i = 0u; i < SIDES; ++i) {
    precise VALUE sum = WEIGHT(0u) * BEFORE[i];
    for (uint k = 1u; k < SIDES; ++k) {
      precise VALUE term = WEIGHT(k) * BEFORE[i + k < SIDES ? i + k : i + k - SIDES];
      sum = sum + term;
    }
    AFTER[i] = sum;
  }
#endif
