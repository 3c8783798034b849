// One workgroup a tile, tile after tile: the points it imports, then its steps, which read its own points and write
// these or the target. Only the steps of a level wait for those of the level before; tiles wait for nobody. Which
// workgroup runs a tile is fixed beforehand, or who is done asks for the next: results don't depend on it.
// osd/vulkan/tile_image.h draws the table.
//
// What holds for all invocations of a workgroup is not known to be so by lavapipe, which runs both sides of every branch
// and the body of a loop once more than needed where the loop is left at its top: hence a branch of its own for each
// kind of step a table has, and loops that are left at their bottom.
//
// Of the push constants: count is tiles, rowLength how many a workgroup may run, firstTask the texel of the first; sides is
// the numbers from a shared point to the next, firstRecord the numbers before the first; firstOutput is the points of a
// slice of the scratch.

layout(constant_id = 10) const uint kCases = 0xffffffffu;  // bit k: the table has steps of case k
layout(constant_id = 11) const uint kPlacing = 0u;         // how points are written: one of those below
layout(constant_id = 12) const bool kShares = true;        // tiles import shared points
layout(constant_id = 13) const uint kOtherCases = 0xffffffffu;  // as kCases, from case 32 on
layout(constant_id = 14) const uint kNormalPage = 1u;           // pages of points come first, then those of normals
layout(constant_id = 15) const bool kNormalPairs = false;       // two packed normals of a face are three aligned vec2
layout(constant_id = 16) const bool kSameWeights = false;       // a face has the same weights at all its stages
layout(constant_id = 19) const bool kPackedRoot = false;        // points of the root are vec3 or vec4; with LONG_STORES

// Osd::TilePlacing. Stores are what lavapipe is slowest at, and cost by their number.
const uint kNumbers = 0u;  // number by number
const uint kWhole = 1u;    // a point is one aligned vec4
const uint kPairs = 2u;    // two packed points of a face are three aligned vec2
const uint kFours = 3u;    // four packed points of a face are three aligned vec4, six are four and a vec2
const uint kThrees = 4u;   // a packed point is a vec3 of scalar layout; where LONG_STORES is defined, as the next
const uint kSixes = 5u;    // and two packed points of a face are three 64-bit numbers, the first of them even
const uint kEights = 6u;   // as kWhole, and two points of a face are four 64-bit numbers, the first of them even

layout(set = 0, binding = 0, std430) writeonly buffer Target { float values[]; } target[8];
layout(set = 0, binding = 0, std430) writeonly buffer WholeTarget { vec4 values[]; } wholeTarget[8];
layout(set = 0, binding = 0, std430) writeonly buffer PairedTarget { vec2 values[]; } pairedTarget[8];
#ifdef LONG_STORES
layout(set = 0, binding = 0, std430) writeonly buffer LongTarget { u64vec2 values[]; } longTarget[8];
layout(set = 0, binding = 0, scalar) writeonly buffer TripleTarget { vec3 values[]; } tripleTarget[8];
layout(set = 0, binding = 0, scalar) writeonly buffer SextupleTarget { u64vec3 values[]; } sextupleTarget[8];
layout(set = 0, binding = 0, scalar) writeonly buffer OctupleTarget { u64vec4 values[]; } octupleTarget[8];
#endif
layout(set = 0, binding = 1, std430) restrict readonly buffer Root { float root[]; };
#ifdef LONG_STORES
layout(set = 0, binding = 1, scalar) restrict readonly buffer RootOfThrees { vec3 rootOfThrees[]; };
layout(set = 0, binding = 1, scalar) restrict readonly buffer RootOfFours { vec4 rootOfFours[]; };
#endif
layout(set = 0, binding = 2, std430) restrict readonly buffer Shared { float sharedNumbers[]; };
layout(set = 0, binding = 7) uniform usamplerBuffer table;

const uint kSharedImport = 0x80000000u;

// Cases, as osd/vulkan/tile_cases.h numbers them: four for each shape of circulants and for rows.
const uint kKept = 0u;     // no stage is wanted
const uint kBoth = 1u;     // the last stage is, others come before it
const uint kWritten = 2u;  // the only stage is
const uint kAlso = 3u;     // the last stage is, and is kept too
const uint kAnySides = 32u;
const uint kFirstDense = 33u;
const uint kFirstLoose = 37u;
const uint kImportedNormals = 41u;
const uint kFirstFaceNormals = 42u;    // two, of hexagons and of any face
const uint kFirstVertexNormals = 44u;  // two, of vertices that read six points and of any
const uint kFirstCornerNormals = 46u;  // two, of hexagons with one neighbour a corner and of any face
const uint kSummedNormals = 48u;

struct Step {
  uint which;
  uint count;        // faces or rows
  uint firstRecord;  // texel
  uint width;        // sides, or entries of a dense row
  uint firstStage;   // texel
  uint kept;         // stages whose points are kept
  uint begins;       // 1: reads what the steps before wrote
  uint written;      // 1: behind these stages is one that is written; 2: the last of these is
};

Step stepAt(uint texel) {
  const uvec4 a = texelFetch(table, int(texel));
  const uvec4 b = texelFetch(table, int(texel) + 1);
  return Step(a.x, a.y, a.z, a.w, b.x, b.y, b.z, b.w);
}

vec4 weightsAt(uint texel) { return uintBitsToFloat(texelFetch(table, int(texel))); }
float weightAt(uint texel, uint k) { return weightsAt(texel + k / 4u)[k % 4u]; }

// Two numbers of points a word.
uint halfOf(uint word, uint k) { return (k & 1u) == 0u ? word & 0xffffu : word >> 16; }

// Of a point, or of a normal.
void writeNumber(uint n, float value, const bool normal) {
  if (kPageShift == 0u) {
    if (normal) {
      target[1].values[n] = value;
    } else {
      target[0].values[n] = value;
    }
    return;
  }
  const uint i = n & ((1u << kPageShift) - 1u);
  // Pages are picked by constants, as in source.glsl.
  switch ((n >> kPageShift) + (normal ? kNormalPage : 0u)) {
    case 0u: target[0].values[i] = value; break;
    case 1u: target[1].values[i] = value; break;
    case 2u: target[2].values[i] = value; break;
    case 3u: target[3].values[i] = value; break;
    case 4u: target[4].values[i] = value; break;
    case 5u: target[5].values[i] = value; break;
    case 6u: target[6].values[i] = value; break;
    default: target[7].values[i] = value;
  }
}

// Points, of kWhole vec4, of the target before the first, and pairs of points. Found once, as a slice is.
uint firstPoint = 0u;
uint firstPair = 0u;
void findTarget() {
  if (kPlacing == kWhole || kPlacing == kEights) firstPoint = push.targetOffset / 4u;
  if (kPlacing == kThrees || kPlacing == kSixes) firstPoint = push.targetOffset / 3u;
  firstPair = firstPoint / 2u;
}

void writePoint(uint point, vec4 p) {
#ifdef LONG_STORES
  if (kPlacing == kWhole || kPlacing == kEights) {
    longTarget[0].values[firstPoint + point * (kTargetStride / 4u)] = u64vec2(longOf(p.xy), longOf(p.zw));
    return;
  }
  if (kPlacing == kThrees || kPlacing == kSixes) {
    tripleTarget[0].values[firstPoint + point] = p.xyz;
    return;
  }
#else
  if (kPlacing == kWhole) {
    wholeTarget[0].values[firstPoint + point * (kTargetStride / 4u)] = p;
    return;
  }
#endif
  const uint n = push.targetOffset + point * kTargetStride;
  writeNumber(n, p.x, false);
  if (kLength > 1u) writeNumber(n + 1u, p.y, false);
  if (kLength > 2u) writeNumber(n + 2u, p.z, false);
  if (kLength > 3u) writeNumber(n + 3u, p.w, false);
}

// Two points of a face, the first of which is even, by half its number and what firstPair says.
void writePair(uint pair, vec4 p, vec4 q) {
#ifdef LONG_STORES
  if (kPlacing == kSixes) {
    sextupleTarget[0].values[pair] = u64vec3(longOf(p.xy), longOf(vec2(p.z, q.x)), longOf(q.yz));
    return;
  }
  if (kPlacing == kEights) {
    octupleTarget[0].values[pair] = u64vec4(longOf(p.xy), longOf(p.zw), longOf(q.xy), longOf(q.zw));
    return;
  }
#endif
  const uint n = push.targetOffset / 2u + pair * 3u;
  pairedTarget[0].values[n] = p.xy;
  pairedTarget[0].values[n + 1u] = vec2(p.z, q.x);
  pairedTarget[0].values[n + 2u] = q.yz;
}

// The points of a face, the first of which is a multiple of four.
void writeFour(uint point, vec4 p, vec4 q, vec4 r, vec4 s) {
  const uint n = (push.targetOffset + point * 3u) / 4u;
  wholeTarget[0].values[n] = vec4(p.xyz, q.x);
  wholeTarget[0].values[n + 1u] = vec4(q.yz, r.xy);
  wholeTarget[0].values[n + 2u] = vec4(r.z, s.xyz);
}

// A hexagon, whose first point is even: nine vec2, of which the first or the last stands alone and the others are whole
// vec4. The same stores either way, since invocations side by side go both.
void writeSix(uint point, const vec4 p[6]) {
  const uint n = (push.targetOffset + point * 3u) / 2u;
  const bool odd = (n & 1u) != 0u;
  vec2 halves[9];
  for (int i = 0; i < 6; i += 2) {
    halves[i / 2 * 3] = p[i].xy;
    halves[i / 2 * 3 + 1] = vec2(p[i].z, p[i + 1].x);
    halves[i / 2 * 3 + 2] = p[i + 1].yz;
  }
  for (int i = 0; i < 4; ++i) {
    const vec4 even = vec4(halves[2 * i], halves[2 * i + 1]);
    wholeTarget[0].values[(n + 1u) / 2u + uint(i)] = odd ? vec4(halves[2 * i + 1], halves[2 * i + 2]) : even;
  }
  pairedTarget[0].values[odd ? n : n + 8u] = odd ? halves[0] : halves[8];
}

float importedNumber(uint import, uint c) {
  if (!kShares || (import & kSharedImport) == 0u) return root[push.sourceOffset + import * kSourceStride + c];
  return sharedNumbers[push.firstRecord + (import & ~kSharedImport) * push.sides + c];
}

// firstRoot: points of the root before the first, where they are packed.
vec4 importedPoint(uint import, uint firstRoot) {
#ifdef LONG_STORES
  if (kPackedRoot) return kLength == 4u ? rootOfFours[firstRoot + import] : vec4(rootOfThrees[firstRoot + import], 0.0);
#endif
  vec4 p = vec4(0.0);
  p.x = importedNumber(import, 0u);
  if (kLength > 1u) p.y = importedNumber(import, 1u);
  if (kLength > 2u) p.z = importedNumber(import, 2u);
  if (kLength > 3u) p.w = importedNumber(import, 3u);
  return p;
}

void importPoints(uint first, uint count) {
  uint i = gl_LocalInvocationID.x;
  if (i >= count) return;
  const uint firstRoot = push.sourceOffset / kSourceStride;
  do {
    keepPoint(i, importedPoint(texelFetch(table, int(first + i / 4u))[i % 4u], firstRoot));
    i += gl_WorkGroupSize.x;
  } while (i < count);
}

#define N 4
#define SHAPE SHAPE_QUAD
#define EVOLVE evolveQuad
#define WRITE writeQuad
#define KEEP keepQuad
#define FACES facesQuad
#include "tile_faces.glsl"
#define N 6
#define SHAPE SHAPE_HEXAGON
#define EVOLVE evolveHexagon
#define WRITE writeHexagon
#define KEEP keepHexagon
#define FACES facesHexagon
#include "tile_faces.glsl"
#define N 4
#define SHAPE SHAPE_EVEN_ODD
#define EVOLVE evolveEvenOdd4
#define WRITE writeEvenOdd4
#define KEEP keepEvenOdd4
#define FACES facesEvenOdd4
#include "tile_faces.glsl"
#define N 6
#define SHAPE SHAPE_EVEN_ODD
#define EVOLVE evolveEvenOdd6
#define WRITE writeEvenOdd6
#define KEEP keepEvenOdd6
#define FACES facesEvenOdd6
#include "tile_faces.glsl"
#define N 8
#define SHAPE SHAPE_EVEN_ODD
#define EVOLVE evolveEvenOdd8
#define WRITE writeEvenOdd8
#define KEEP keepEvenOdd8
#define FACES facesEvenOdd8
#include "tile_faces.glsl"
#define N 3
#define SHAPE SHAPE_DIRECT
#define EVOLVE evolveDirect3
#define WRITE writeDirect3
#define KEEP keepDirect3
#define FACES facesDirect3
#include "tile_faces.glsl"
#define N 5
#define SHAPE SHAPE_DIRECT
#define EVOLVE evolveDirect5
#define WRITE writeDirect5
#define KEEP keepDirect5
#define FACES facesDirect5
#include "tile_faces.glsl"
#define N 7
#define SHAPE SHAPE_DIRECT
#define EVOLVE evolveDirect7
#define WRITE writeDirect7
#define KEEP keepDirect7
#define FACES facesDirect7
#include "tile_faces.glsl"

#include "tile_any_faces.glsl"
#include "tile_rows.glsl"
#include "unit.glsl"
#include "tile_normals.glsl"

// A branch on constants alone comes first: the evaluator cuts off those that a table never takes, calls and all
// (osd/vulkan/pruned_code.h), since drivers that inline all of them compile for seconds.
#define RUN_CASE(cases, case_, run)                  \
  if (((cases >> ((case_) & 31u)) & 1u) != 0u) {     \
    if (step.which == (case_)) run;                  \
  }
#define RUN_CASES(cases, first, run)                    \
  RUN_CASE(cases, (first) + kKept, run(step, kKept))       \
  RUN_CASE(cases, (first) + kBoth, run(step, kBoth))       \
  RUN_CASE(cases, (first) + kWritten, run(step, kWritten)) \
  RUN_CASE(cases, (first) + kAlso, run(step, kAlso))

void runStep(Step step) {
  RUN_CASES(kCases, 0u, facesQuad)
  RUN_CASES(kCases, 4u, facesHexagon)
  RUN_CASES(kCases, 8u, facesEvenOdd4)
  RUN_CASES(kCases, 12u, facesEvenOdd6)
  RUN_CASES(kCases, 16u, facesEvenOdd8)
  RUN_CASES(kCases, 20u, facesDirect3)
  RUN_CASES(kCases, 24u, facesDirect5)
  RUN_CASES(kCases, 28u, facesDirect7)
  RUN_CASE(kOtherCases, kAnySides, facesAnySides(step))
  RUN_CASES(kOtherCases, kFirstDense, denseRows)
  RUN_CASES(kOtherCases, kFirstLoose, looseRows)
  RUN_CASE(kOtherCases, kImportedNormals, importNormals(step))
  RUN_CASE(kOtherCases, kFirstFaceNormals, frameNormals(step, 6u, false))
  RUN_CASE(kOtherCases, kFirstFaceNormals + 1u, frameNormals(step, step.width, false))
  RUN_CASE(kOtherCases, kFirstVertexNormals, frameNormals(step, 6u, true))
  RUN_CASE(kOtherCases, kFirstVertexNormals + 1u, frameNormals(step, step.width, true))
  // Unrolled only where a write is short: with pages it is a switch, and compiling takes long.
  RUN_CASE(kOtherCases, kFirstCornerNormals, cornerNormals(step, kPageShift == 0u ? 6u : step.width, 1u))
  RUN_CASE(kOtherCases, kFirstCornerNormals + 1u, cornerNormals(step, step.width, step.kept))
  RUN_CASE(kOtherCases, kSummedNormals, summedNormals(step))
}

void main() {
  findSlice();
  findTarget();
  uint t = gl_WorkGroupID.x;
  uint ran = 0u;
  do {
    const uvec4 tile = texelFetch(table, int(push.firstTask + t));
    importPoints(tile.x, tile.y);
    uint s = 0u;
    do {
      const Step step = stepAt(tile.z + 2u * s);
      if (step.begins != 0u) settle();
      runStep(step);
      ++s;
    } while (s < tile.w);
    ++ran;
    const bool more = ran < push.rowLength;
    if (kDealt) {
      if (more) askForTile();
    }
    // The next tile overwrites what this one reads.
    settle();
    t = !kDealt ? t + gl_NumWorkGroups.x : more ? givenTile() : push.count;
  } while (t < push.count);
}
