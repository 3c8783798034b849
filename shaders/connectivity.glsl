// What the kernels of connectivity share: whole numbers alone. Numbers that a defective mesh gives are checked before
// they are used as indices, so that it can do no worse than give a wrong result, which is reported.

layout(local_size_x_id = 0) in;
layout(constant_id = 6) const uint kPageShift = 0u;  // a page is 2^kPageShift numbers; 0: the source is one page

// osd/vulkan/topology_passes.h has the same struct.
layout(push_constant) uniform Push {
  uint count;      // items of this dispatch
  uint rowLength;  // invocations in a row of the two-dimensional dispatch
  uint first;      // the first item
  uint vertices;   // of the control mesh, and the next two
  uint faces;
  uint halfEdges;
  uint parents;      // half-edges of the level before the one that is refined
  uint windowBegin;  // number the bound range of what is written begins with
  uint windowSize;   // numbers bound
  uint value;        // see the kernels
  uint shift;
  uint most;  // valence
} push;

uint invocation() { return gl_GlobalInvocationID.y * push.rowLength + gl_GlobalInvocationID.x; }

const uint kNone = 0xFFFFFFFFu;
// Sums, least numbers and digits are taken of so many numbers by one invocation.
const uint kPiece = 64u;
// Numbers that a digit of a sort may be.
const uint kBins = 16u;

// What can be wrong with a half-edge: osd/vulkan/topology_passes.h has the same.
const uint kFaceDefect = 1u;
const uint kVertexDefect = 2u;
const uint kOpenDefect = 3u;
const uint kTwinDefect = 4u;
const uint kValenceDefect = 5u;
uint defectOf(uint h, uint kind) { return kind == 0u ? kNone : 8u * h + kind; }
