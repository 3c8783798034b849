#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "far/tables/face_varying.h"
#include "osd/cpu_evaluator.h"
#include "tests/support/golden_chain.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {

using Numbers = std::vector<double>;

constexpr std::int32_t kChannelLevels = 3;

/// A mesh with a value for each corner.
struct Channel {
  PolyMesh mesh;
  Numbers values;
  std::vector<std::int32_t> corners;
  std::int32_t length = 2;

  /// Another value, for the next corner.
  void add(const Numbers& value) {
    corners.push_back(static_cast<std::int32_t>(values.size() / static_cast<std::size_t>(length)));
    values.insert(values.end(), value.begin(), value.end());
  }
};

inline Far::Refinement refinedChannel(const std::string& scheme, const PolyMesh& mesh,
                                      std::int32_t levels = kChannelLevels) {
  const Far::Topology control = toTopology(mesh);
  auto refinement = Far::refine(control, goldenChain(scheme, control, levels));
  if (!refinement) throw std::runtime_error(refinement.error().message);
  return std::move(*refinement);
}

inline Far::FaceVarying builtVarying(const Far::Refinement& refinement, const Channel& channel) {
  auto result = Far::FaceVarying::build(refinement, {channel.length, channel.values, channel.corners});
  if (!result) throw std::runtime_error(result.error().message);
  return std::move(*result);
}

/// What a level makes of its parent's values.
inline Numbers evaluateChannel(const Far::LevelTable& table, const Numbers& source, std::int32_t length) {
  Numbers target(static_cast<std::size_t>(table.targetCount) * static_cast<std::size_t>(length));
  const Osd::BufferDescriptor desc{0, length, length};
  Osd::SerialEvaluator evaluator;
  const auto done = evaluator.evaluate<double>(table, {source, desc}, {target, desc});
  if (!done) throw std::runtime_error(done.error().message);
  return target;
}

/// The values of each level.

/// Tests by the name of a scheme; face_varying_test.cpp has the list.
class FaceVaryingBy : public testing::TestWithParam<std::string> {};

}  // namespace honeycomb::Test
