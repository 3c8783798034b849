// A level that zip has made, read. Its half-edges in the faces of the level before keep their numbers, so that the loop
// of a half-edge is that of the level in which it was born: up to level 1 they are stored, later ones are hexagons,
//     3^j H + 6g .. 3^j H + 6g + 5      of level j + 1, H half-edges of the control mesh

layout(set = 0, binding = 1) restrict readonly buffer Faces { uint face[]; };           // of level 1
layout(set = 0, binding = 2) restrict readonly buffer Offsets { uint faceOffsets[]; };  // of level 1

uvec2 loopOf(uint h) {
  uint born = 3u * push.halfEdges;
  if (h < born) {
    const uint f = face[h];
    return uvec2(faceOffsets[f], faceOffsets[f + 1u]);
  }
  while (h / 3u >= born) born *= 3u;
  const uint begin = h - (h - born) % 6u;
  return uvec2(begin, begin + 6u);
}

uint prevOf(uint h) {
  const uvec2 loop = loopOf(h);
  return h == loop.x ? loop.y - 1u : h - 1u;
}

uint nextOf(uint h) {
  const uvec2 loop = loopOf(h);
  return h + 1u == loop.y ? loop.x : h + 1u;
}

// Where C(h) stands, h one of push.parents half-edges: behind 6 for each vertex before vert(h), and 2 for each half-edge
// that leaves it before h, which are, from vertex v, the half-edges v, C(v) and B(next v). `source` is vert of the level
// before, of the control mesh's corners the place itself.
uint cornerOf(uint h) {
  // A level of a defective mesh has any numbers: they are no worse as places.
  const uint found = sourceNumber(min(h, push.parents - 1u));
  if (push.parents == push.halfEdges) return min(found, 3u * push.halfEdges - 2u);
  const uint born = push.parents / 3u;
  const uint turn = h < born ? 0u : 1u + (h - born) % 2u;
  return push.parents + 6u * min(found, born - 1u) + 2u * turn;
}
