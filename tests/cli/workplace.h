#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "run_program.h"

namespace honeycomb::Test {

/// A folder of its own for each test, and the files to run the program on.
class Workplace : public testing::Test {
 protected:
  Workplace();
  ~Workplace() override;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  /// Writes a file and returns its path.
  std::string file(const std::string& name, const std::string& text) const;
  std::string cache(const std::string& name, std::int32_t points, std::int32_t frames,
                    const std::vector<float>& numbers) const;
  std::string read(const std::string& name) const;
  std::set<std::string> listing() const;
  /// A cache of the mesh bent differently in each frame.
  std::string bentCache(const std::string& name, const std::string& obj, std::int32_t frames) const;

 private:
  std::filesystem::path folder_;
};

/// Expects exit 1, one error line that has all the fragments, and no file that wasn't there before.
#define EXPECT_REFUSED(arguments, ...)                                                                      \
  do {                                                                                                      \
    const std::vector<std::string> refusedArguments = arguments;                                            \
    const auto filesBefore = listing();                                                                     \
    const Outcome refused = run(refusedArguments);                                                          \
    EXPECT_EQ(refused.exitCode, 1) << refused.out;                                                          \
    EXPECT_TRUE(isOneErrorLine(refused.err)) << refused.err;                                                \
    EXPECT_THAT(refused.err, testing::AllOfArray(std::vector<testing::Matcher<std::string>>{__VA_ARGS__})); \
    EXPECT_EQ(listing(), filesBefore);                                                                      \
  } while (false)

/// "v x y z" and "f ..." lines of a unit cube.
std::string cubeObj();
/// A grid of n x n quads over the unit square, open on all sides.
std::string gridObj(int n);
/// A closed torus of n x n quads.
std::string torusObj(int n);
/// The mesh bent differently in each frame: coordinates of frame f, from an OBJ made by one of the above.
std::vector<float> bentFrame(const std::string& obj, int f);
/// The OBJ with other positions, written so that they read back to the same floats.
std::string withPositions(const std::string& obj, const std::vector<float>& positions);

}  // namespace honeycomb::Test
