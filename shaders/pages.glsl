// What is read at random places, of type NUMBER: bound as pages, because a storage buffer's range is limited.
layout(set = 0, binding = 0) restrict readonly buffer Source { NUMBER values[]; } source[8];

NUMBER sourceNumber(uint n) {
  if (kPageShift == 0u) return source[0].values[n];
  const uint i = n & ((1u << kPageShift) - 1u);
  // Pages are picked by constants: indices that differ between invocations need a feature that not every device has.
  switch (n >> kPageShift) {
    case 0u: return source[0].values[i];
    case 1u: return source[1].values[i];
    case 2u: return source[2].values[i];
    case 3u: return source[3].values[i];
    case 4u: return source[4].values[i];
    case 5u: return source[5].values[i];
    case 6u: return source[6].values[i];
    default: return source[7].values[i];
  }
}
