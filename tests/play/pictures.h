#pragma once

#include <string>
#include <utility>

#include "apps/viewer/picture.h"

namespace honeycomb::Test {

/// For the program's environment: Mesa's software rasteriser leaks with every graphics pipeline it compiles, and is
/// unloaded before the program ends, so that the leak checker can't pass over it by name.
inline const std::pair<std::string, std::string> kLeaksOfDrivers{"ASAN_OPTIONS", "detect_leaks=0"};

/// A PNG's pixels; empty where it can't be read.
Viewer::Picture readPng(const std::string& path);

/// Share of the picture's pixels in which some channel differs by more than `tolerance`, 0..1; 1 for other sizes.
double difference(const Viewer::Picture& a, const Viewer::Picture& b, int tolerance = 12);

struct Colour {
  int red = 0, green = 0, blue = 0;
};
Colour colourAt(const Viewer::Picture& picture, std::int32_t x, std::int32_t y);

/// Share of the pixels for which test(colour) holds.
template <class Test>
double shareOf(const Viewer::Picture& picture, const Test& test) {
  std::int64_t count = 0;
  for (std::int32_t y = 0; y < picture.height; ++y)
    for (std::int32_t x = 0; x < picture.width; ++x) count += test(colourAt(picture, x, y)) ? 1 : 0;
  return static_cast<double>(count) / (static_cast<double>(picture.width) * picture.height);
}

}  // namespace honeycomb::Test
