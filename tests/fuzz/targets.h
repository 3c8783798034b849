#pragma once

#include <cstdint>
#include <span>

/// What hostile bytes are tried on, a file each. libFuzzer runs each as a program (the preset fuzz; libfuzzer.cpp),
/// the test program fuzz_test all of them with mutations that are the same every time (driver.cpp).
namespace honeycomb::Fuzz {

using Bytes = std::span<const std::uint8_t>;

/// Each reads `bytes`, where they have checksums also with these put right, as somebody would who means harm, and does
/// all that can be done with what comes out. Were they taken? Ends the program where a promise isn't kept.
bool obj(Bytes bytes);
bool ply(Bytes bytes);
bool pc2(Bytes bytes);
bool mdd(Bytes bytes);
bool table(Bytes bytes);
bool pipelines(Bytes bytes);
bool arrays(Bytes bytes);

/// Ends the program, saying `promise`, where it isn't kept.
void expect(bool kept, const char* promise);

}  // namespace honeycomb::Fuzz
