#include "io/pc2.h"

#include "tests/fuzz/read_frames.h"

namespace honeycomb::Fuzz {

bool pc2(Bytes bytes) {
  return readFrames<Io::Pc2Reader>(bytes);
}

}  // namespace honeycomb::Fuzz
