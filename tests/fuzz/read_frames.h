#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "far/base/index.h"
#include "io/frame_source.h"
#include "tests/fuzz/memory_file.h"

namespace honeycomb::Fuzz {

/// Reads the first frames of a point cache, its last, and those that aren't there.
inline void useFrames(const Io::FrameSource& frames) {
  const Io::FrameInfo& info = frames.info();
  expect(info.pointCount > 0 && info.frameCount > 0, "a cache has points and frames");
  std::vector<float> storage;
  const auto read = [&](std::int32_t f) {
    const auto points = frames.frame(f, storage);
    expect(points || !points.error().message.empty(), "a refusal says why");
    if (!points) return false;
    expect(points->size() == 3 * at(info.pointCount), "a frame has a position a point");
    expect(std::ranges::all_of(*points, [](float x) { return std::isfinite(x); }), "positions are finite");
    return true;
  };
  for (std::int32_t f = 0; f < std::min(info.frameCount, 8); ++f) read(f);
  read(info.frameCount - 1);
  expect(!read(-1) && !read(info.frameCount), "frames are counted from 0");
}

/// Opens the bytes as a cache of the kind, and reads them. Were they taken?
template <class Reader>
bool readFrames(Bytes bytes) {
  const MemoryFile file(bytes);
  const Result<Reader> frames = Reader::open(file.path());
  if (frames) useFrames(*frames);
  expect(frames || frames.error().message.starts_with(file.path().string()), "a refusal names the file");
  return frames.has_value();
}

}  // namespace honeycomb::Fuzz
