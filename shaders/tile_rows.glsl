// Rows: one stage each, kept or written or both.

void placeRow(Step step, uint row, uint output_, const uint stages, vec4 p) {
  if (stages != kKept) writePoint(output_, p);
  if (stages != kWritten) keepPoint(texelFetch(table, int(step.firstStage)).x + row, p);
}

// record   (width+1)/2 words of two points each, then the output; whole texels
void denseRows(Step step, const uint stages) {
  uint row = gl_LocalInvocationID.x;
  if (row >= step.count) return;
  const uint weights = texelFetch(table, int(step.firstStage)).y;
  const uint words = (step.width + 1u) / 2u;
  do {
    const uint record = step.firstRecord + row * ((words + 4u) / 4u);
    uvec4 corners = texelFetch(table, int(record));
    vec4 w = weightsAt(weights);
    precise vec4 sum = w.x * ownPoint(corners.x & 0xffffu);
    uint j = 1u;
    if (step.width > 1u) {
      do {
        if (j % 8u == 0u) corners = texelFetch(table, int(record + j / 8u));
        if (j % 4u == 0u) w = weightsAt(weights + j / 4u);
        precise vec4 term = w[j % 4u] * ownPoint(halfOf(corners[j / 2u % 4u], j));
        sum = sum + term;
        ++j;
      } while (j < step.width);
    }
    placeRow(step, row, texelFetch(table, int(record + words / 4u))[words % 4u], stages, sum);
    row += gl_WorkGroupSize.x;
  } while (row < step.count);
}

// record   first entry (a texel), entries, output, 0
// entries  two a texel: point, weight, point, weight
void looseRows(Step step, const uint stages) {
  uint row = gl_LocalInvocationID.x;
  if (row >= step.count) return;
  do {
    const uvec4 record = texelFetch(table, int(step.firstRecord + row));
    uvec4 entries = texelFetch(table, int(record.x));
    precise vec4 sum = uintBitsToFloat(entries.y) * ownPoint(entries.x);
    uint j = 1u;
    if (record.y > 1u) {
      do {
        if (j % 2u == 0u) entries = texelFetch(table, int(record.x + j / 2u));
        const uvec2 entry = j % 2u == 0u ? entries.xy : entries.zw;
        precise vec4 term = uintBitsToFloat(entry.y) * ownPoint(entry.x);
        sum = sum + term;
        ++j;
      } while (j < record.y);
    }
    placeRow(step, row, record.z, stages, sum);
    row += gl_WorkGroupSize.x;
  } while (row < step.count);
}
