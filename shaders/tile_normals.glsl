// Normals of the last level: fast ones from the normals of faces, which stand behind the tile's points; exact ones from
// points. osd/vulkan/tile_normal_image.cpp packs the records.

layout(set = 0, binding = 4, std430) restrict readonly buffer SharedNormals { float sharedNormals[]; };

void writeNormal(uint point, vec3 v) {
  const uint n = push.normalOffset + point * kNormalStride;
  writeNumber(n, v.x, true);
  writeNumber(n + 1u, v.y, true);
  writeNumber(n + 2u, v.z, true);
}

// Those of points of a face, the first of which is even.
void writeNormalPair(uint point, vec3 v, vec3 w) {
  const uint n = (push.normalOffset + point * 3u) / 2u;
  pairedTarget[1].values[n] = v.xy;
  pairedTarget[1].values[n + 1u] = vec2(v.z, w.x);
  pairedTarget[1].values[n + 2u] = w.yz;
}

// record   four shared normals a texel
void importNormals(Step step) {
  uint i = gl_LocalInvocationID.x;
  if (i >= step.count) return;
  do {
    const uint n = 3u * texelFetch(table, int(step.firstRecord + i / 4u))[i % 4u];
    keepPoint(step.kept + i, vec4(sharedNormals[n], sharedNormals[n + 1u], sharedNormals[n + 2u], 0.0));
    i += gl_WorkGroupSize.x;
  } while (i < step.count);
}

vec3 numberedPoint(uint record, uint k) {
  return ownPoint(halfOf(texelFetch(table, int(record + k / 8u))[k / 2u % 4u], k)).xyz;
}

// A x B of FrameBatch, of n points; the weights of a point in both stand side by side.
vec3 frameNormal(uint record, uint weights, uint n) {
  const vec3 first = numberedPoint(record, 0u);
  vec4 pair = weightsAt(weights);
  precise vec3 t1 = pair.x * first, t2 = pair.y * first;
  uint j = 1u;
  if (n > 1u) {
    do {
      const vec3 p = numberedPoint(record, j);
      pair = weightsAt(weights + j / 2u);
      const vec2 w = (j & 1u) == 0u ? pair.xy : pair.zw;
      precise vec3 a = w.x * p, b = w.y * p;
      t1 = t1 + a;
      t2 = t2 + b;
      ++j;
    } while (j < n);
  }
  return unitNormal(t1, t2);
}

// record   (n+1)/2 words of two points each, then the output; whole texels
void frameNormals(Step step, uint n, const bool written) {
  uint i = gl_LocalInvocationID.x;
  if (i >= step.count) return;
  const uint words = (n + 1u) / 2u;
  do {
    const uint record = step.firstRecord + i * ((words + 4u) / 4u);
    const vec3 v = frameNormal(record, step.firstStage, n);
    if (written) {
      writeNormal(texelFetch(table, int(record + words / 4u))[words % 4u], v);
    } else {
      keepPoint(step.kept + i, vec4(v, 0.0));
    }
    i += gl_WorkGroupSize.x;
  } while (i < step.count);
}

// Of corner i of a face: twice the face's normal, then those of its neighbours.
vec3 cornerNormal(uint record, vec3 twice, uint i, uint neighbours) {
  const uint first = 1u + i * neighbours;
  precise vec3 sum = twice + numberedPoint(record, first);
  uint k = 1u;
  if (neighbours > 1u) {
    do {
      sum = sum + numberedPoint(record, first + k);
      ++k;
    } while (k < neighbours);
  }
  return unit(sum);
}

// record   (n*neighbours+2)/2 words of two normals each: the face's, then `neighbours` a corner; the first output; whole
//          texels
void cornerNormals(Step step, uint n, uint neighbours) {
  uint face = gl_LocalInvocationID.x;
  if (face >= step.count) return;
  const uint words = (n * neighbours + 2u) / 2u;
  do {
    const uint record = step.firstRecord + face * ((words + 4u) / 4u);
    const vec3 own = ownPoint(texelFetch(table, int(record)).x & 0xffffu).xyz;
    precise vec3 twice = own + own;
    const uint first = texelFetch(table, int(record + words / 4u))[words % 4u];
    uint i = 0u;
    do {
      const vec3 v = cornerNormal(record, twice, i, neighbours);
      ++i;
      if (kNormalPairs && n % 2u == 0u) {
        writeNormalPair(first + i - 1u, v, cornerNormal(record, twice, i, neighbours));
        ++i;
      } else {
        writeNormal(first + i - 1u, v);
      }
    } while (i < n);
    face += gl_WorkGroupSize.x;
  } while (face < step.count);
}

// record   first normal (a texel), normals, output, 0
// normals  eight a texel
void summedNormals(Step step) {
  uint row = gl_LocalInvocationID.x;
  if (row >= step.count) return;
  do {
    const uvec4 record = texelFetch(table, int(step.firstRecord + row));
    precise vec3 sum = vec3(0.0);
    if (record.y > 0u) sum = numberedPoint(record.x, 0u);
    uint k = 1u;
    if (record.y > 1u) {
      do {
        sum = sum + numberedPoint(record.x, k);
        ++k;
      } while (k < record.y);
    }
    writeNormal(record.z, unit(sum));
    row += gl_WorkGroupSize.x;
  } while (row < step.count);
}
