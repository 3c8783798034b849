// What all evaluation kernels share: constants, push constants, and how numbers of large buffers are reached.
// The order of operations of each kernel is written down in far/tables/level_table.h and limit_table.h. Every value of
// the points' arithmetic is `precise`, so that no operation is contracted and all evaluators give the same bits.

layout(local_size_x_id = 0) in;
layout(constant_id = 1) const uint kLength = 3u;        // values a point
layout(constant_id = 2) const uint kSourceStride = 3u;  // numbers from one source point to the next
layout(constant_id = 3) const uint kTargetStride = 3u;
layout(constant_id = 4) const uint kNormalStride = 3u;
layout(constant_id = 5) const uint kSides = 6u;         // 0: push.sides
layout(constant_id = 6) const uint kPageShift = 0u;     // a page is 2^kPageShift numbers; 0: the source is one page
layout(constant_id = 7) const bool kWindowed = false;   // the target is larger than what is bound
layout(constant_id = 8) const uint kForm = 0u;          // of a circulant: one of the four below

// Far::CirculantForm.
#define SHAPE_DIRECT 0
#define SHAPE_EVEN_ODD 1
#define SHAPE_QUAD 2
#define SHAPE_HEXAGON 3

const uint kProjectionBlock = 256u;

// osd/vulkan/kernels.h has the same struct.
layout(push_constant) uniform Push {
  uint count;         // faces, rows, blocks or elements of this dispatch
  uint rowLength;     // invocations in a row of the two-dimensional dispatch
  uint sides;
  uint firstIndex;    // of the dispatch, in the bound range of `indices`
  uint firstWeight;   // in the bound range of `weights`
  uint firstRecord;   // in the bound range of `records`
  uint firstTask;     // in the bound range of `tasks`
  uint firstOutput;   // point
  uint sourceOffset;  // numbers before the first point
  uint targetOffset;
  uint windowBegin;   // number the bound range of `target` begins with
  uint windowSize;    // numbers bound
  uint normalOffset;
  uint normalBegin;
  uint normalSize;
  float weights[16];  // of a circulant of up to 16 sides, or of dense rows
} push;

uint invocation() { return gl_GlobalInvocationID.y * push.rowLength + gl_GlobalInvocationID.x; }
