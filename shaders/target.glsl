// The points that are written. Of a target larger than a page one window is bound; what lies outside is left to the
// dispatches of the other windows.
layout(set = 0, binding = 3) restrict writeonly buffer Target { float values[]; } target;

void writeTarget(uint point, uint c, float value) {
  uint n = push.targetOffset + point * kTargetStride + c;
  if (kWindowed) {
    n -= push.windowBegin;
    if (n >= push.windowSize) return;
  }
  target.values[n] = value;
}
