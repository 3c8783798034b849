#include "io/mdd.h"

#include "tests/fuzz/read_frames.h"

namespace honeycomb::Fuzz {

bool mdd(Bytes bytes) {
  return readFrames<Io::MddReader>(bytes);
}

}  // namespace honeycomb::Fuzz
